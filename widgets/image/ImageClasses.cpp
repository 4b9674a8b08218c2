// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageClasses.h"

#include "foxglove/Image.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/image/ImagePixels.h"

namespace widgets {

std::vector<std::string> classNames(const robotlink::StreamStore& store, const std::string& path,
                                    const foxglove::RawImage& image, robotlink::Instant time) {
  const auto slash = path.find('/');
  if (image.encoding() != "mono8" || slash == std::string::npos || path.compare(slash, 8, "/images/") != 0)
    return {};
  const std::string regionsPath = path.substr(0, slash + 1) + robotlink::kColorRegions.name;
  const auto* regions = store.latestAs<robotcontrol::ColorRegions>(regionsPath, time);
  if (regions == nullptr) return {};
  return {regions->class_names().begin(), regions->class_names().end()};
}

std::vector<robotlink::Rgb> classColors(const std::vector<std::string>& names,
                                        const robotlink::FieldDescription* field) {
  std::vector<robotlink::Rgb> colors;
  for (const std::string& name : names) {
    const auto* color = field != nullptr ? field->color(name) : nullptr;
    colors.push_back(color != nullptr ? *color : robotlink::Rgb{});
  }
  return colors;
}

std::string classNameOf(const PixelValue& pixel, const std::vector<std::string>& names,
                        const robotlink::FieldDescription* field) {
  if (pixel.value) {
    const auto index = static_cast<std::size_t>(*pixel.value);
    return index < names.size() ? names[index] : std::string();
  }
  if (pixel.ycbcr || field == nullptr) return {};
  for (const auto& color : field->palette) {
    if (color.rgb == pixel.rgb) return color.name;
  }
  return {};
}

}  // namespace widgets
