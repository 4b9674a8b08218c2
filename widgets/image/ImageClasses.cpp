// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageClasses.h"

#include "colortool/image/ClassPresets.h"
#include "colortool/scoring/Evaluation.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/image/ImagePixels.h"

namespace widgets {
namespace {

constexpr char kUnknown[] = "unknown";
constexpr robotlink::Rgb kUnknownColor{128, 128, 128};

/// The classes by their numbers in images of true classes (STREAMS.md).
colortool::ColorClasses presetClasses() {
  return colortool::findClassPreset("2002")->classes();
}

std::vector<std::string> trueClassNames() {
  const colortool::ColorClasses classes = presetClasses();
  std::vector<std::string> names(colortool::Evaluation::kIgnored + 1U);
  for (int i = 0; i < classes.size(); ++i) names[static_cast<std::size_t>(i)] = classes.name(i);
  names.back() = kUnknown;
  return names;
}

}  // namespace

std::vector<std::string> classNames(const robotlink::StreamStore& store, const std::string& path,
                                    const foxglove::RawImage& image, robotlink::Instant time) {
  const auto slash = path.find('/');
  if (image.encoding() != "mono8" || slash == std::string::npos) return {};
  if (path.substr(slash + 1) == robotlink::kOracleClasses.name) return trueClassNames();
  if (path.compare(slash, 8, "/images/") != 0) return {};
  const std::string regionsPath = path.substr(0, slash + 1) + robotlink::kColorRegions.name;
  const auto* regions = store.latestAs<robotcontrol::ColorRegions>(regionsPath, time);
  if (regions == nullptr) return {};
  return {regions->class_names().begin(), regions->class_names().end()};
}

std::vector<robotlink::Rgb> classColors(const std::vector<std::string>& names,
                                        const robotlink::FieldDescription* field) {
  const colortool::ColorClasses preset = presetClasses();
  std::vector<robotlink::Rgb> colors;
  for (const std::string& name : names) {
    const auto* color = field != nullptr ? field->color(name) : nullptr;
    const robotlink::Rgb other = name == kUnknown ? kUnknownColor : preset.shownColor(preset.index(name));
    colors.push_back(color != nullptr ? *color : other);
  }
  return colors;
}

std::string classNameOf(const PixelValue& pixel, const std::vector<std::string>& names,
                        const robotlink::FieldDescription* field) {
  if (pixel.value) {
    const auto index = static_cast<std::size_t>(*pixel.value);
    return index < names.size() ? names[index] : std::string();
  }
  if (pixel.ycbcr || pixel.depth || field == nullptr) return {};
  for (const auto& color : field->palette) {
    if (color.rgb == pixel.rgb) return color.name;
  }
  return {};
}

}  // namespace widgets
