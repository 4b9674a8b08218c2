// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QSizeF>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>

#include "robotlink/base/Geometry.h"
#include "widgets/scene/render/SceneCamera.h"

class QPainter;

namespace widgets {

/// A part of the gizmo that can be grabbed. Planes are named by the axes along which they move.
enum class GizmoHandle : std::uint8_t { kNone, kX, kY, kZ, kXY, kYZ, kXZ, kTurnX, kTurnY, kTurnZ };

/// The handles at an object by which it is moved and turned with the mouse: three axes, three planes and
/// three rings, as large on the screen at any distance. A plain value; poses are in the field's frame.
struct Gizmo {
  robotlink::Pose3 pose = robotlink::Pose3::Identity();
  /// The directions of the handles in its columns: those of the field, or of the object itself.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  /// The length of an axis in m, as this camera sees it in a widget of this size.
  double length(const SceneCamera& camera, const QSizeF& widget) const;
  /// The handle at a place of the widget; of several the one that is nearest to the place.
  GizmoHandle handleAt(const SceneCamera& camera, const QSizeF& widget, const QPointF& at) const;
};

/// The axes of a handle, 0 to 2: the one that it follows or turns about, or the two of its plane; -1: none.
struct GizmoAxes {
  int first = -1, second = -1;
  bool isTurn = false;
  /// The axis at right angles to a plane.
  int normal() const { return 3 - first - second; }
};
GizmoAxes axesOf(GizmoHandle handle);

inline constexpr std::array kGizmoHandles{GizmoHandle::kX,     GizmoHandle::kY,     GizmoHandle::kZ,
                                          GizmoHandle::kXY,    GizmoHandle::kYZ,    GizmoHandle::kXZ,
                                          GizmoHandle::kTurnX, GizmoHandle::kTurnY, GizmoHandle::kTurnZ};

/// A handle on the screen: a line from near the gizmo's middle, an area, or a closed line. Empty: it cannot
/// be seen, because it is behind the camera or seen from its edge.
QPolygonF gizmoOutline(const Gizmo& gizmo, GizmoHandle handle, const SceneCamera& camera,
                       const QSizeF& widget);

/// A drag of one handle, from its press to its release. A pure function of where the mouse is: the camera
/// must stay.
class GizmoDrag {
 public:
  /// `at`: where the handle was pressed.
  GizmoDrag(GizmoHandle handle, const Gizmo& gizmo, const SceneCamera& camera, const QSizeF& widget,
            const QPointF& at);

  /// The object's pose with the mouse at a place. `isSnapping`: coordinates along the handle are multiples
  /// of kSnapLength, angles of the turn multiples of kSnapAngle.
  robotlink::Pose3 poseAt(const QPointF& at, bool isSnapping) const;
  /// The text shown while dragging: "x 1.250 m (+0.250)", "z +15.0°".
  QString readout(const QPointF& at, bool isSnapping) const;
  GizmoHandle handle() const { return handle_; }
  const robotlink::Pose3& start() const { return gizmo_.pose; }

  static constexpr double kSnapLength = 0.1, kSnapAngle = robotlink::radians(15);

 private:
  /// The movement of the object, in the gizmo's axes, m.
  robotlink::Vector3 shift(const QPointF& at, bool isSnapping) const;
  /// The turn of the object about the handle's axis, rad.
  double angle(const QPointF& at, bool isSnapping) const;
  /// The point of the handle's axis or plane that is under a place; unset: there is none.
  std::optional<robotlink::Vector3> onHandle(const QPointF& at) const;

  GizmoHandle handle_;
  Gizmo gizmo_;
  SceneCamera camera_;
  QSizeF widget_;
  QPointF pressed_;
  std::optional<robotlink::Vector3> grabbed_;
};

/// Paints the handles over a picture; `hot` is the one under the mouse or in the hand.
void paintGizmo(QPainter& painter, const Gizmo& gizmo, const SceneCamera& camera, const QSizeF& widget,
                GizmoHandle hot);

}  // namespace widgets
