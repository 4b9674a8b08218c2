// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/color/LabelStrokes.h"

#include <algorithm>
#include <map>

namespace app {
namespace {

using colortool::DiscStroke;
using robotlink::Image;

constexpr std::uint8_t kPassedOver = 255;

bool isInside(const Image& labels, int x, int y) {
  const std::uint8_t label = labels.row(y)[x];
  for (int row = y - 1; row <= y + 1; ++row) {
    for (int column = x - 1; column <= x + 1; ++column)
      if (labels.row(row)[column] != label) return false;
  }
  return true;
}

}  // namespace

std::vector<DiscStroke> strokesInside(const Image& labels, const std::string& image,
                                      const colortool::ColorClasses& classes, std::size_t count) {
  std::map<std::uint8_t, std::vector<std::pair<int, int>>> inside;
  for (int y = 1; y + 1 < labels.height; ++y) {
    for (int x = 1; x + 1 < labels.width; ++x) {
      const std::uint8_t label = labels.row(y)[x];
      if (label != kPassedOver && label < classes.size() && isInside(labels, x, y))
        inside[label].emplace_back(x, y);
    }
  }
  const double scale = static_cast<double>(DiscStroke::kReferenceWidth) / labels.width;
  std::vector<DiscStroke> strokes;
  for (const auto& [label, places] : inside) {
    const std::string name = label == 0 ? std::string(DiscStroke::kBackground) : classes.name(label);
    const std::size_t wanted = std::min(count, places.size());
    for (std::size_t i = 0; i < wanted; ++i) {
      const auto& [x, y] = places[(2 * i + 1) * places.size() / (2 * wanted)];
      strokes.push_back({image, name, x * scale, y * scale, scale});
    }
  }
  return strokes;
}

robotlink::Result<std::vector<DiscStroke>> strokesOfLabels(const ColorImages& images,
                                                           const std::filesystem::path& labels,
                                                           const colortool::ColorClasses& classes,
                                                           std::size_t count) {
  std::vector<DiscStroke> strokes;
  for (const std::string& name : images.names()) {
    const auto file = labels / (std::filesystem::path(name).stem().string() + ".png");
    std::error_code error;
    if (!std::filesystem::exists(file, error)) continue;
    const auto classesOfPixels = ColorImages::loadLabels(file);
    if (!classesOfPixels) return tl::unexpected(classesOfPixels.error());
    const auto added = strokesInside(*classesOfPixels, name, classes, count);
    strokes.insert(strokes.end(), added.begin(), added.end());
  }
  if (strokes.empty())
    return robotlink::failure("color.labels",
                              "no image has labels here: add PNG files with the images' names",
                              {labels.string(), 0, 0});
  return strokes;
}

}  // namespace app
