// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorLayers.h"

#include <algorithm>
#include <array>

#include "colortool/table/ColorTable.h"

namespace widgets {
namespace {

using colortool::ColorTable;

QRgb heat(int unsure) {
  return qRgb(std::min(255, 2 * unsure), std::clamp(2 * unsure - 255, 0, 255), unsure / 8);
}

/// An image of the colors that `color` returns for the cell of each pixel.
template <typename Color>
QImage byCell(const robotlink::ImageView& image, QImage::Format format, const Color& color) {
  if (image.empty()) return {};
  QImage result(image.width, image.height, format);
  for (int y = 0; y < image.height; ++y) {
    auto* to = reinterpret_cast<QRgb*>(result.scanLine(y));
    for (int x = 0; x < image.width; ++x)
      to[x] = color(ColorTable::cellOf(robotlink::pixelYCbCr(image, x, y)));
  }
  return result;
}

}  // namespace

QVector<QLineF> outlineOf(const colortool::PixelArea& area) {
  QVector<QLineF> lines;
  for (const colortool::PixelEdge& edge : colortool::outline(area))
    lines.append(QLineF(edge.x0, edge.y0, edge.x1, edge.y1));
  return lines;
}

std::vector<StrokeMark> strokeMarks(const colortool::Samples& samples, const colortool::SampleImage& place) {
  std::vector<StrokeMark> marks;
  for (const colortool::StrokePtr& stroke : samples.strokes) {
    const colortool::SampleImage* image = samples.image(stroke->image);
    if (image == nullptr || image->name != place.name || image->camera != place.camera) continue;
    const robotlink::Rgb color = samples.classes.shownColor(stroke->colorClass);
    marks.push_back({stroke->colorClass == 0 ? QColor(150, 150, 150) : QColor(color.r, color.g, color.b),
                     stroke->mustNotBe, outlineOf(stroke->area)});
  }
  return marks;
}

QImage marginImage(const robotlink::ImageView& image, std::span<const std::uint8_t> margins) {
  std::array<QRgb, 256> colors;
  for (int i = 0; i < 256; ++i) colors[static_cast<std::size_t>(i)] = heat(255 - i);
  return byCell(image, QImage::Format_RGB32, [&](std::size_t cell) { return colors[margins[cell]]; });
}

QImage differenceImage(const QImage& image, const robotlink::Image& now, const robotlink::Image& before,
                       std::span<const robotlink::Rgb> classColors) {
  QImage result(now.width, now.height, QImage::Format_RGB32);
  for (int y = 0; y < now.height; ++y) {
    auto* to = reinterpret_cast<QRgb*>(result.scanLine(y));
    const auto* below = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    const std::uint8_t *after = now.row(y), *first = before.row(y);
    for (int x = 0; x < now.width; ++x) {
      if (after[x] == first[x]) {
        const int gray = qGray(below[x]) / (after[x] == 0 ? 5 : 3);
        to[x] = qRgb(gray, gray, gray);
      } else {
        const robotlink::Rgb color =
            after[x] < classColors.size() ? classColors[after[x]] : robotlink::Rgb{255, 0, 255};
        // Pixels that no longer have a class would be invisible in black.
        to[x] = after[x] == 0 ? qRgb(255, 0, 255) : qRgb(color.r, color.g, color.b);
      }
    }
  }
  return result;
}

QImage selectionShade(const robotlink::ImageView& image, const colortool::CellSet& selection) {
  constexpr QRgb kDark = qRgba(0, 0, 0, 190), kClear = qRgba(0, 0, 0, 0);
  return byCell(image, QImage::Format_ARGB32_Premultiplied,
                [&](std::size_t cell) { return selection.contains(cell) ? kClear : kDark; });
}

}  // namespace widgets
