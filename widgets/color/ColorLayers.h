// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QVector>
#include <memory>
#include <span>
#include <vector>

#include "colortool/CellSet.h"
#include "colortool/Samples.h"
#include "widgets/color/ColorFrame.h"

namespace widgets {

// What is painted over and beside an image of the colour tool. Pure functions; any thread.

/// The outline of a stroke in the image.
struct StrokeMark {
  QColor color;
  bool mustNotBe = false;
  QVector<QLineF> edges;  ///< image coordinates, pixels
};
/// Returns the marks of all strokes that were made in this very image.
std::vector<StrokeMark> strokeMarks(const colortool::Samples& samples, const colortool::SampleImage& place);
QVector<QLineF> outlineOf(const colortool::PixelArea& area);

/// How sure a table is of each pixel: from black (sure) by red to yellow (as likely another class).
QImage marginImage(const robotlink::ImageView& image, std::span<const std::uint8_t> margins);
/// Where two images of classes differ, in the colours of `now`; what is equal is grey, the darker the more
/// it is of none. `image` is the picture below.
QImage differenceImage(const QImage& image, const robotlink::Image& now, const robotlink::Image& before,
                       std::span<const robotlink::Rgb> classColors);
/// Darkens all but the pixels whose cells are selected (Format_ARGB32_Premultiplied), to be laid over any.
QImage selectionShade(const robotlink::ImageView& image, const colortool::CellSet& selection);

}  // namespace widgets
