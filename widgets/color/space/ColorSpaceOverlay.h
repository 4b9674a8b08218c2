// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

#include "widgets/color/space/ColorSpaceCamera.h"
#include "widgets/color/space/ColorSpaceCut.h"

class QPainter;

// Paints the box, cuts and cells of a color space behind and in front of its picture. Pure functions of their
// arguments.
namespace widgets {

/// The solid that a color space fills, a cube or a cylinder, with the names of its channels.
struct ColorSpaceBox {
  colortool::ColorSpace space = colortool::ColorSpace::kYCbCr;
  ColorSpaceProjection projection;
  /// Colors of the edges and of the names.
  QColor lines, text;
};
/// Paints the edges behind all colors.
void paintBoxBehind(QPainter& painter, const ColorSpaceBox& box);
/// Paints the edges in front of all colors, and the names.
void paintBoxInFront(QPainter& painter, const ColorSpaceBox& box);
/// Paints the section of the solid by a cut at a channel's value; nothing for other cuts.
void paintCut(QPainter& painter, const ColorSpaceBox& box, const ColorSpaceCut& cut, const QColor& color);
/// Paints the edges of a cell; `corners` as ColorLattice::cornersOf() returns them.
void paintCell(QPainter& painter, const ColorSpaceProjection& projection,
               const std::array<Eigen::Vector3f, 8>& corners, const QColor& light, const QColor& dark);

}  // namespace widgets
