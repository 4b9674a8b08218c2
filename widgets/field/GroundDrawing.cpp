// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/GroundDrawing.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "foxglove/Scene.pb.h"
#include "robotlink/packages/Conversions.h"
#include "widgets/drawings/CurrentDrawings.h"
#include "widgets/drawings/MessageColors.h"
#include "widgets/drawings/MessageFonts.h"
#include "widgets/world/WorldDrawings.h"

namespace widgets {
namespace {

using foxglove::LinePrimitive;
using robotlink::Pose3;
using robotlink::Vector3;

/// Paints the primitives of one entity.
class AbovePainter {
 public:
  AbovePainter(QPainter& painter, const Pose3& frameInField, const QTransform& fieldToWidget,
               Qt::PenStyle style)
      : painter_(painter),
        frame_(frameInField),
        toWidget_(fieldToWidget),
        style_(style),
        scale_(std::hypot(fieldToWidget.m11(), fieldToWidget.m12())) {}

  void paint(const foxglove::SceneEntity& entity) {
    for (const auto& triangles : entity.triangles()) paintTriangles(triangles);
    for (const auto& cube : entity.cubes()) paintCube(cube);
    for (const auto& sphere : entity.spheres()) paintRound(sphere.pose(), sphere.size(), sphere.color());
    for (const auto& cylinder : entity.cylinders())
      paintRound(cylinder.pose(), cylinder.size(), cylinder.color());
    for (const auto& lines : entity.lines()) paintLines(lines);
    for (const auto& arrow : entity.arrows()) paintArrow(arrow);
    for (const auto& text : entity.texts()) paintText(text);
  }

 private:
  QPointF project(const Pose3& pose, const Vector3& point) const {
    const Vector3 inField = frame_ * (pose * point);
    return toWidget_.map(QPointF(inField.x(), inField.y()));
  }
  QPointF project(const Pose3& pose, const foxglove::Point3& point) const {
    return project(pose, Vector3(point.x(), point.y(), point.z()));
  }

  void fill(const foxglove::Color& color) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(qColor(color));
  }

  void paintTriangles(const foxglove::TriangleListPrimitive& triangles) {
    const Pose3 pose = robotlink::pose3(triangles.pose());
    const int count = triangles.indices_size() > 0 ? triangles.indices_size() : triangles.points_size();
    // Without antialiasing, since neighboring triangles would show a seam.
    painter_.setRenderHint(QPainter::Antialiasing, false);
    for (int i = 0; i + 2 < count; i += 3) {
      QPolygonF corners;
      for (int corner = i; corner < i + 3; ++corner) {
        const int at = triangles.indices_size() > 0 ? static_cast<int>(triangles.indices(corner)) : corner;
        if (at >= 0 && at < triangles.points_size()) corners << project(pose, triangles.points(at));
      }
      fill(i < triangles.colors_size() ? triangles.colors(i) : triangles.color());
      painter_.drawConvexPolygon(corners);
    }
    painter_.setRenderHint(QPainter::Antialiasing);
  }

  void paintCube(const foxglove::CubePrimitive& cube) {
    const Pose3 pose = robotlink::pose3(cube.pose());
    const Vector3 half = robotlink::vector3(cube.size()) / 2;
    fill(cube.color());
    // All six faces are painted; those in front cover the others.
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        QPolygonF face;
        for (const auto& [u, v] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
          Vector3 corner;
          corner[axis] = side * half[axis];
          corner[(axis + 1) % 3] = u * half[(axis + 1) % 3];
          corner[(axis + 2) % 3] = v * half[(axis + 2) % 3];
          face << project(pose, corner);
        }
        painter_.drawPolygon(face);
      }
    }
  }

  void paintRound(const foxglove::Pose& primitive, const foxglove::Vector3& size,
                  const foxglove::Color& color) {
    const Pose3 pose = robotlink::pose3(primitive);
    constexpr int kCorners = 32;
    QPolygonF outline;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * robotlink::kPi * i / kCorners;
      outline << project(pose, Vector3(size.x() / 2 * std::cos(angle), size.y() / 2 * std::sin(angle), 0));
    }
    fill(color);
    painter_.drawPolygon(outline);
  }

  QPen penFor(const LinePrimitive& lines, const foxglove::Color& color) const {
    const double width = lines.scale_invariant() ? lines.thickness() : lines.thickness() * scale_;
    return {qColor(color), std::max(1.0, width), style_, Qt::RoundCap, Qt::RoundJoin};
  }

  void paintLines(const LinePrimitive& lines) {
    const Pose3 pose = robotlink::pose3(lines.pose());
    QPolygonF points;
    const auto add = [&](int i) {
      if (i >= 0 && i < lines.points_size()) points << project(pose, lines.points(i));
    };
    for (const auto index : lines.indices()) add(static_cast<int>(index));
    for (int i = 0; lines.indices_size() == 0 && i < lines.points_size(); ++i) add(i);
    painter_.setBrush(Qt::NoBrush);
    if (lines.colors_size() == 0 && lines.type() != LinePrimitive::LINE_LIST) {
      painter_.setPen(penFor(lines, lines.color()));
      return lines.type() == LinePrimitive::LINE_LOOP ? painter_.drawPolygon(points)
                                                      : painter_.drawPolyline(points);
    }
    const int step = lines.type() == LinePrimitive::LINE_LIST ? 2 : 1;
    if (lines.type() == LinePrimitive::LINE_LOOP && !points.isEmpty()) points << points.front();
    for (int i = 0; i + 1 < points.size(); i += step) {
      painter_.setPen(penFor(lines, i < lines.colors_size() ? lines.colors(i) : lines.color()));
      painter_.drawLine(points[i], points[i + 1]);
    }
  }

  void paintArrow(const foxglove::ArrowPrimitive& arrow) {
    const Pose3 pose = robotlink::pose3(arrow.pose());
    const double length = arrow.shaft_length() + arrow.head_length(), half = arrow.head_diameter() / 2;
    painter_.setPen(
        QPen(qColor(arrow.color()), std::max(1.0, arrow.shaft_diameter() * scale_), style_, Qt::FlatCap));
    painter_.drawLine(project(pose, Vector3::Zero()), project(pose, Vector3(arrow.shaft_length(), 0, 0)));
    fill(arrow.color());
    painter_.drawPolygon(QPolygonF({project(pose, Vector3(length, 0, 0)),
                                    project(pose, Vector3(arrow.shaft_length(), half, 0)),
                                    project(pose, Vector3(arrow.shaft_length(), -half, 0))}));
  }

  void paintText(const foxglove::TextPrimitive& text) {
    QFont font = painter_.font();
    font.setPixelSize(fontPixels(text.scale_invariant() ? text.font_size() : text.font_size() * scale_));
    painter_.setFont(font);
    painter_.setPen(qColor(text.color()));
    painter_.drawText(project(robotlink::pose3(text.pose()), Vector3::Zero()),
                      QString::fromStdString(text.text()));
  }

  QPainter& painter_;
  const Pose3& frame_;
  const QTransform& toWidget_;
  const Qt::PenStyle style_;
  const double scale_;  // pixels per meter
};

}  // namespace

void paintFromAbove(QPainter& painter, const foxglove::SceneEntity& entity, const Pose3& frameInField,
                    const QTransform& fieldToWidget, Qt::PenStyle style) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  AbovePainter(painter, frameInField, fieldToWidget, style).paint(entity);
  painter.restore();
}

void paintFromAbove(QPainter& painter, const std::vector<WorldDrawing>& drawings,
                    const QTransform& fieldToWidget) {
  for (const WorldDrawing& drawing : drawings) {
    painter.setOpacity(drawingOpacity(drawing.id, drawing.old));
    paintFromAbove(painter, *drawing.entity, drawing.frameInField, fieldToWidget,
                   isDrawnInShadow(drawing.id) ? Qt::DashLine : Qt::SolidLine);
  }
  painter.setOpacity(1);
}

}  // namespace widgets
