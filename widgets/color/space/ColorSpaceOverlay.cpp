// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceOverlay.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

namespace widgets {
namespace {

using colortool::ColorSpace;
using Eigen::Vector3f;

constexpr float kSide = 0.5F;
constexpr int kArcs = 72;

enum class Part : std::uint8_t { kBehind, kInFront };

/// An edge is in front if both of its faces are visible; silhouette edges are painted with those behind.
Part partOf(bool firstFaces, bool secondFaces) {
  return firstFaces && secondFaces ? Part::kInFront : Part::kBehind;
}

Vector3f onCircle(double turn, double radius, float height) {
  const double angle = 2 * std::numbers::pi * turn;
  return {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle)), height};
}

void paintLine(QPainter& painter, const ColorSpaceBox& box, const Vector3f& from, const Vector3f& to) {
  painter.drawLine(box.projection.point(from), box.projection.point(to));
}

void paintCube(QPainter& painter, const ColorSpaceBox& box, Part part) {
  const auto faces = [&](int axis, float side) {
    const Vector3f normal = side * Vector3f::Unit(axis);
    return box.projection.facesViewer(kSide * normal, normal);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const float sideU : {-1.F, 1.F}) {
      for (const float sideV : {-1.F, 1.F}) {
        if (partOf(faces(u, sideU), faces(v, sideV)) != part) continue;
        Vector3f from = Vector3f::Zero();
        from[axis] = -kSide;
        from[u] = kSide * sideU;
        from[v] = kSide * sideV;
        paintLine(painter, box, from, from + Vector3f::Unit(axis));
      }
    }
  }
}

void paintCylinder(QPainter& painter, const ColorSpaceBox& box, Part part) {
  for (const float end : {-1.F, 1.F}) {
    const Vector3f cap = end * Vector3f::UnitZ();
    const bool capFaces = box.projection.facesViewer(kSide * cap, cap);
    for (int i = 0; i < kArcs; ++i) {
      const double from = double(i) / kArcs, to = double(i + 1) / kArcs;
      const Vector3f outwards = onCircle((from + to) / 2, 1, 0);
      const bool sideFaces = box.projection.facesViewer(kSide * outwards + kSide * cap, outwards);
      if (partOf(capFaces, sideFaces) != part) continue;
      paintLine(painter, box, onCircle(from, 0.5, kSide * end), onCircle(to, 0.5, kSide * end));
    }
  }
  if (part != Part::kBehind) return;
  // The gray axis, and the direction from which angles are measured.
  paintLine(painter, box, {0, 0, -kSide}, {0, 0, kSide});
  paintLine(painter, box, {0, 0, -kSide}, onCircle(0, 0.5, -kSide));
  // The two vertical lines of the silhouette, where the lateral surface turns away from the viewer.
  bool before = box.projection.facesViewer(onCircle(-1.0 / kArcs, 0.5, 0), onCircle(-1.0 / kArcs, 1, 0));
  for (int i = 0; i < kArcs; ++i) {
    const double turn = double(i) / kArcs;
    const bool now = box.projection.facesViewer(onCircle(turn, 0.5, 0), onCircle(turn, 1, 0));
    if (now != before) paintLine(painter, box, onCircle(turn, 0.5, -kSide), onCircle(turn, 0.5, kSide));
    before = now;
  }
}

void paintSolid(QPainter& painter, const ColorSpaceBox& box, Part part) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(box.lines, 1));
  colortool::isCylinder(box.space) ? paintCylinder(painter, box, part) : paintCube(painter, box, part);
  painter.restore();
}

void paintBoxName(QPainter& painter, const ColorSpaceBox& box, const Vector3f& at, const char* name) {
  QRectF plate(0, 0, 60, 20);
  plate.moveCenter(box.projection.point(at));
  painter.drawText(plate, Qt::AlignCenter, QString::fromLatin1(name));
}

void paintNames(QPainter& painter, const ColorSpaceBox& box) {
  constexpr float kBeyond = 0.06F;
  const auto names = colortool::channelNames(box.space);
  painter.save();
  painter.setPen(box.text);
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  if (colortool::isCylinder(box.space)) {
    paintBoxName(painter, box, {0, 0, kSide + kBeyond}, names[2]);
    paintBoxName(painter, box, onCircle(0, 0.5 + 1.5 * double{kBeyond}, -kSide), names[1]);
    paintBoxName(painter, box, onCircle(1.0 / 12, 0.5 + 1.5 * double{kBeyond}, -kSide), names[0]);
  } else {
    for (int channel = 0; channel < 3; ++channel) {
      const int axis = box.space == ColorSpace::kYCbCr ? (channel + 2) % 3 : channel;
      Vector3f at = Vector3f::Constant(-kSide);
      at[axis] = kSide + kBeyond;
      paintBoxName(painter, box, at, names[static_cast<std::size_t>(channel)]);
    }
  }
  painter.restore();
}

}  // namespace

void paintBoxBehind(QPainter& painter, const ColorSpaceBox& box) {
  paintSolid(painter, box, Part::kBehind);
}

void paintBoxInFront(QPainter& painter, const ColorSpaceBox& box) {
  paintSolid(painter, box, Part::kInFront);
  paintNames(painter, box);
}

void paintCut(QPainter& painter, const ColorSpaceBox& box, const ColorSpaceCut& cut, const QColor& color) {
  using Along = ColorSpaceCut::Along;
  if (cut.along == Along::kNothing || cut.along == Along::kView) return;
  const int channel = static_cast<int>(cut.along) - static_cast<int>(Along::kFirst);
  const auto at = static_cast<float>(cut.at) - kSide;
  QPolygonF outline;
  if (!colortool::isCylinder(box.space)) {
    const int axis = box.space == ColorSpace::kYCbCr ? (channel + 2) % 3 : channel;
    for (const auto& [u, v] : {std::pair{-kSide, -kSide}, {kSide, -kSide}, {kSide, kSide}, {-kSide, kSide}}) {
      Vector3f corner;
      corner[axis] = at;
      corner[(axis + 1) % 3] = u;
      corner[(axis + 2) % 3] = v;
      outline << box.projection.point(corner);
    }
  } else if (channel == 2) {
    for (int i = 0; i < kArcs; ++i) outline << box.projection.point(onCircle(double(i) / kArcs, 0.5, at));
  } else if (channel == 0) {
    for (const float end : {-kSide, kSide}) outline << box.projection.point({0, 0, end});
    for (const float end : {kSide, -kSide}) outline << box.projection.point(onCircle(cut.at, 0.5, end));
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 1.2, Qt::DashLine));
  painter.drawPolygon(outline);
  painter.restore();
}

void paintCell(QPainter& painter, const ColorSpaceProjection& projection,
               const std::array<Vector3f, 8>& corners, const QColor& light, const QColor& dark) {
  QPainterPath path;
  for (std::size_t from = 0; from < 8; ++from) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((from & bit) != 0) continue;
      path.moveTo(projection.point(corners[from]));
      path.lineTo(projection.point(corners[from | bit]));
    }
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.strokePath(path, QPen(dark, 3));
  painter.strokePath(path, QPen(light, 1.2));
  painter.restore();
}

}  // namespace widgets
