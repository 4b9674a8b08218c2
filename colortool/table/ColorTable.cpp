// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/ColorTable.h"

#include <algorithm>

namespace colortool {

using robotlink::Image;
using robotlink::ImageView;
using robotlink::PixelFormat;

ColorTable ColorTable::translated(std::span<const std::uint8_t> cells,
                                  std::span<const std::uint8_t> numbers) {
  ColorTable table;
  if (cells.size() != kCellCount) return table;
  std::ranges::transform(cells, table.cells_.begin(), [&](std::uint8_t cell) {
    return cell < numbers.size() ? numbers[cell] : ColorClasses::kNone;
  });
  return table;
}

void ColorTable::classify(const ImageView& image, Image& classes, Instructions instructions) const {
  classes.width = std::max(0, image.width);
  classes.height = std::max(0, image.height);
  classes.format = PixelFormat::kMono8;
  classes.data.resize(static_cast<std::size_t>(classes.width) * static_cast<std::size_t>(classes.height));
  ClassifyRow classifyRow = instructions == Instructions::kPlain ? nullptr : avx2ClassifyRow(image.format);
  if (classifyRow == nullptr) classifyRow = plainClassifyRow(image.format);
  if (image.empty() || classifyRow == nullptr) {
    std::ranges::fill(classes.data, ColorClasses::kNone);
    return;
  }
  const bool planar = image.format == PixelFormat::kNv12;
  for (int y = 0; y < image.height; ++y) {
    classifyRow(cells_.data(), {image.row(y), planar ? image.chromaRow(y) : nullptr, image.width},
                classes.row(y));
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
