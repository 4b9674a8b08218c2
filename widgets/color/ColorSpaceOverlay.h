// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

#include "widgets/color/ColorSpaceCamera.h"
#include "widgets/color/ColorSpaceCut.h"

class QPainter;

namespace widgets {

/// The solid that a colour space fills, around the picture of what is in it: a cube or a cylinder, with the
/// names of its channels. Painted in two parts, before and after the picture.
struct ColorSpaceBox {
  colortool::ColorSpace space = colortool::ColorSpace::kYCbCr;
  ColorSpaceProjection projection;
  QColor lines, text;
};
/// What is behind all colours, or beside them.
void paintBoxBehind(QPainter& painter, const ColorSpaceBox& box);
/// What is in front of all colours; and the names.
void paintBoxInFront(QPainter& painter, const ColorSpaceBox& box);
/// Where a plane across a channel cuts the solid; nothing for other cuts.
void paintCut(QPainter& painter, const ColorSpaceBox& box, const ColorSpaceCut& cut, const QColor& color);
/// The edges of a cell, by its corners as ColorLattice has them.
void paintCell(QPainter& painter, const ColorSpaceProjection& projection,
               const std::array<Eigen::Vector3f, 8>& corners, const QColor& light, const QColor& dark);

}  // namespace widgets
