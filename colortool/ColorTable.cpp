// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/ColorTable.h"

#include <algorithm>

namespace colortool {

using robotlink::Image;
using robotlink::ImageView;
using robotlink::PixelFormat;

ColorTable ColorTable::translated(std::span<const std::uint8_t> cells,
                                  std::span<const std::uint8_t> numbers) {
  ColorTable table;
  if (cells.size() != table.cells_.size()) return table;
  std::ranges::transform(cells, table.cells_.begin(), [&](std::uint8_t cell) {
    return cell < numbers.size() ? numbers[cell] : ColorClasses::kNone;
  });
  return table;
}

void ColorTable::classifyYuyvRow(const std::uint8_t* pixels, int width, std::uint8_t* classes) const {
  const std::uint8_t* cells = cells_.data();
  for (int x = 0; x + 1 < width; x += 2, pixels += 4) {
    const std::size_t chroma =
        (static_cast<std::size_t>(pixels[1] >> 2) << 6) | static_cast<std::size_t>(pixels[3] >> 2);
    classes[x] = cells[(static_cast<std::size_t>(pixels[0] >> 2) << 12) | chroma];
    classes[x + 1] = cells[(static_cast<std::size_t>(pixels[2] >> 2) << 12) | chroma];
  }
}

void ColorTable::classifyRgbRow(const std::uint8_t* pixels, int width, std::uint8_t* classes) const {
  for (int x = 0; x < width; ++x, pixels += 3)
    classes[x] = classOf(robotlink::toYCbCr({pixels[0], pixels[1], pixels[2]}));
}

void ColorTable::classify(const ImageView& image, Image& classes) const {
  classes.width = std::max(0, image.width);
  classes.height = std::max(0, image.height);
  classes.format = PixelFormat::kMono8;
  classes.data.resize(static_cast<std::size_t>(classes.width) * static_cast<std::size_t>(classes.height));
  if (image.empty() || image.format == PixelFormat::kMono8) {
    std::ranges::fill(classes.data, ColorClasses::kNone);
    return;
  }
  for (int y = 0; y < image.height; ++y) {
    if (image.format == PixelFormat::kYuyv)
      classifyYuyvRow(image.row(y), image.width, classes.row(y));
    else
      classifyRgbRow(image.row(y), image.width, classes.row(y));
  }
}

Image shownImage(const ImageView& classImage, const ColorClasses& classes) {
  Image shown(classImage.width, classImage.height, PixelFormat::kRgb8);
  for (int y = 0; y < classImage.height; ++y) {
    const std::uint8_t* from = classImage.row(y);
    std::uint8_t* to = shown.row(y);
    for (int x = 0; x < classImage.width; ++x, to += 3) {
      const robotlink::Rgb color =
          classes.shownColor(from[x] < classes.size() ? from[x] : ColorClasses::kNone);
      to[0] = color.r;
      to[1] = color.g;
      to[2] = color.b;
    }
  }
  return shown;
}

}  // namespace colortool
