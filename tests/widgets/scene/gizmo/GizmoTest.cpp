// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/gizmo/Gizmo.h"

#include <gtest/gtest.h>

#include <QLineF>

namespace widgets {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;

class GizmoTest : public testing::Test {
 protected:
  GizmoTest() {
    gizmo.pose.translation() = Vector3(0.52, -0.31, 0.2);
    camera.target = gizmo.pose.translation();
    camera.distance = 4;
    camera.azimuth = robotlink::radians(-60);
    camera.elevation = robotlink::radians(35);
  }
  QPointF at(const Vector3& place) const { return camera.project(size, place).value_or(QPointF(-1, -1)); }
  /// Along an axis from the middle, in lengths of an axis.
  Vector3 onAxis(int axis, double share) const {
    return gizmo.pose.translation() + share * gizmo.length(camera, size) * gizmo.axes.col(axis);
  }
  GizmoDrag grab(GizmoHandle handle, const Vector3& place) const {
    return {handle, gizmo, camera, size, at(place)};
  }

  const QSizeF size{640, 480};
  SceneCamera camera;
  Gizmo gizmo;
};

TEST_F(GizmoTest, eachHandleIsHitWhereItIsSeen) {
  EXPECT_EQ(gizmo.handleAt(camera, size, at(onAxis(0, 0.95))), GizmoHandle::kX);
  EXPECT_EQ(gizmo.handleAt(camera, size, at(onAxis(1, 0.95))), GizmoHandle::kY);
  EXPECT_EQ(gizmo.handleAt(camera, size, at(onAxis(2, 0.95))), GizmoHandle::kZ);
  EXPECT_EQ(gizmo.handleAt(camera, size, {5, 5}), GizmoHandle::kNone);
  for (const GizmoHandle handle : kGizmoHandles) {
    const QPolygonF outline = gizmoOutline(gizmo, handle, camera, size);
    ASSERT_FALSE(outline.isEmpty()) << int(handle);
    if (axesOf(handle).second < 0) continue;
    EXPECT_EQ(gizmo.handleAt(camera, size, (outline[0] + outline[2]) / 2), handle);
  }
}

TEST_F(GizmoTest, itIsAsLargeFarAwayAsNear) {
  const double near = QLineF(at(onAxis(2, 0)), at(onAxis(2, 1))).length();
  camera.distance = 40;
  EXPECT_NEAR(QLineF(at(onAxis(2, 0)), at(onAxis(2, 1))).length(), near, 3);
}

TEST_F(GizmoTest, anAxisMovesAlongItAndNothingElse) {
  const GizmoDrag drag = grab(GizmoHandle::kX, onAxis(0, 0.9));
  const Pose3 moved = drag.poseAt(at(onAxis(0, 0.9) + Vector3(0.25, 0, 0)), false);
  EXPECT_TRUE(moved.translation().isApprox(Vector3(0.77, -0.31, 0.2), 1e-6)) << moved.translation();
  EXPECT_TRUE(moved.linear().isApprox(gizmo.pose.linear()));
  EXPECT_TRUE(drag.poseAt(at(onAxis(0, 0.9)), false).translation().isApprox(gizmo.pose.translation()));
}

TEST_F(GizmoTest, aPlaneMovesAlongTwoAxes) {
  const Vector3 grabbed = gizmo.pose.translation() + Vector3(0.1, 0.1, 0);
  const GizmoDrag drag = grab(GizmoHandle::kXY, grabbed);
  const Pose3 moved = drag.poseAt(at(grabbed + Vector3(-0.4, 0.3, 0)), false);
  EXPECT_TRUE(moved.translation().isApprox(Vector3(0.12, -0.01, 0.2), 1e-6)) << moved.translation();
}

TEST_F(GizmoTest, snappingPutsCoordinatesOnTheGrid) {
  const GizmoDrag drag = grab(GizmoHandle::kX, onAxis(0, 0.9));
  const QPointF place = at(onAxis(0, 0.9) + Vector3(0.25, 0, 0));
  const Vector3 snapped = drag.poseAt(place, true).translation();
  EXPECT_NEAR(snapped.x(), 0.8, 1e-9);
  EXPECT_EQ(snapped.y(), -0.31);
  EXPECT_EQ(drag.readout(place, true).toStdString(), "x: 0.800 m (+0.280)");
}

TEST_F(GizmoTest, aRingTurnsAboutItsAxis) {
  const double radius = 0.8 * gizmo.length(camera, size);
  const auto onRing = [&](double angle) {
    return Vector3(gizmo.pose.translation() + radius * Vector3(std::cos(angle), std::sin(angle), 0));
  };
  const GizmoDrag drag = grab(GizmoHandle::kTurnZ, onRing(0.2));
  const Pose3 turned = drag.poseAt(at(onRing(0.8)), false);
  EXPECT_NEAR(std::atan2(turned.linear()(1, 0), turned.linear()(0, 0)), 0.6, 1e-6);
  EXPECT_TRUE(turned.translation().isApprox(gizmo.pose.translation()));
  const Pose3 snapped = drag.poseAt(at(onRing(0.8)), true);
  EXPECT_NEAR(std::atan2(snapped.linear()(1, 0), snapped.linear()(0, 0)), robotlink::radians(30), 1e-9);
}

TEST_F(GizmoTest, aRingSeenFromItsEdgeIsRolled) {
  camera.elevation = 0;
  const GizmoDrag drag = grab(GizmoHandle::kTurnZ, onAxis(2, 0));
  const Pose3 turned = drag.poseAt(at(onAxis(2, 0)) + QPointF(30, 0), false);
  const double angle = std::atan2(turned.linear()(1, 0), turned.linear()(0, 0));
  // What is before the axis goes with the mouse to the right, which is counterclockwise from above.
  EXPECT_GT(angle, 0.2);
  EXPECT_LT(angle, 0.8);
}

TEST_F(GizmoTest, theObjectsOwnAxesMoveItWhereItPoints) {
  gizmo.pose.linear() = Eigen::AngleAxisd(robotlink::kPi / 2, Vector3::UnitZ()).toRotationMatrix();
  gizmo.axes = gizmo.pose.linear();
  const GizmoDrag drag = grab(GizmoHandle::kX, onAxis(0, 0.9));
  const Vector3 moved = drag.poseAt(at(onAxis(0, 0.9) + Vector3(0, 0.3, 0)), false).translation();
  EXPECT_TRUE(moved.isApprox(Vector3(0.52, -0.01, 0.2), 1e-6)) << moved;
}

}  // namespace
}  // namespace widgets
