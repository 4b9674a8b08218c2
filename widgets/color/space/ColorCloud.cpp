// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorCloud.h"

#include "colortool/table/ColorTable.h"

namespace widgets {
namespace {

constexpr std::uint32_t kBits = 7;

std::uint32_t cellOf(robotlink::YCbCr color) {
  return (static_cast<std::uint32_t>(color.y >> 1) << (2 * kBits)) |
         (static_cast<std::uint32_t>(color.cb >> 1) << kBits) | static_cast<std::uint32_t>(color.cr >> 1);
}

}  // namespace

std::size_t ColorCloud::pixelsIn(std::size_t cell) const {
  std::size_t pixels = 0;
  for (const CloudPoint& point : points) {
    if (colortool::ColorTable::cellOf(point.color) == cell) pixels += point.pixels;
  }
  return pixels;
}

std::shared_ptr<const ColorCloud> CloudMaker::cloudOf(const robotlink::ImageView& image) {
  places_.resize(std::size_t{1} << (3 * kBits));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const robotlink::YCbCr color = robotlink::pixelYCbCr(image, x, y);
      const std::uint32_t index = cellOf(color);
      Place& place = places_[index];
      if (place.pixels++ != 0) continue;
      place.color = color;
      used_.push_back(index);
    }
  }
  auto cloud = std::make_shared<ColorCloud>();
  cloud->points.reserve(used_.size());
  for (const std::uint32_t index : used_) {
    cloud->points.push_back({places_[index].color, places_[index].pixels});
    places_[index].pixels = 0;
  }
  used_.clear();
  return cloud;
}

}  // namespace widgets
