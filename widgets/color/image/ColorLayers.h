// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QVector>
#include <memory>
#include <span>
#include <vector>

#include "colortool/samples/Samples.h"
#include "colortool/table/CellSet.h"
#include "widgets/color/ColorFrame.h"

// Paints the layers over and next to an image of the color tool. Pure functions; any thread.
namespace widgets {

/// The outline of a stroke in its image.
struct StrokeMark {
  /// The color of its class.
  QColor color;
  /// Whether the stroke says what its pixels are not; drawn dotted.
  bool mustNotBe = false;
  /// In image coordinates, pixels.
  QVector<QLineF> edges;
};
/// Returns the marks of all strokes that were made in this very image.
std::vector<StrokeMark> strokeMarks(const colortool::Samples& samples, const colortool::SampleImage& place);
/// The edges between the area's pixels and others, in image coordinates.
QVector<QLineF> outlineOf(const colortool::PixelArea& area);

/// The certainty of a table in each pixel, by ColorTable::cellOf: from black (sure) over red to yellow (a
/// second class is as likely).
QImage marginImage(const robotlink::ImageView& image, std::span<const std::uint8_t> margins);
/// The pixels whose classes differ, in the colors of `now` (magenta where it has no class). All others are a
/// dark gray version of `image`, darker still where they have no class.
QImage differenceImage(const QImage& image, const robotlink::Image& now, const robotlink::Image& before,
                       std::span<const robotlink::Rgb> classColors);
/// Darkens all pixels but those whose cells are selected; to be laid over an image
/// (Format_ARGB32_Premultiplied).
QImage selectionShade(const robotlink::ImageView& image, const colortool::CellSet& selection);

}  // namespace widgets
