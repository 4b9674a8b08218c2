// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/ViewFrustum.h"

#include <gtest/gtest.h>

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {
namespace {

/// A camera 0.2 m above the ground that looks straight ahead, 90 degrees wide and 60 high.
robotcontrol::CameraPose cameraAhead() {
  robotcontrol::CameraPose camera;
  Pose3 pose = Pose3::Identity();
  pose.translation() = Vector3(0, 0, 0.2);
  assign(*camera.mutable_camera_in_robot(), pose);
  camera.set_horizontal_angle(kPi / 2);
  camera.set_vertical_angle(kPi / 3);
  return camera;
}

TEST(ViewFrustumTest, showsWhatIsWithinTheOpeningAngles) {
  const ViewFrustum view(cameraAhead());
  EXPECT_TRUE(view.shows({1, 0, 0.2}));
  EXPECT_TRUE(view.shows({1, 0.95, 0.2}));
  EXPECT_FALSE(view.shows({1, 1.05, 0.2}));
  EXPECT_FALSE(view.shows({-1, 0, 0.2}));
  EXPECT_TRUE(view.shows({1, 0, 0.2 - 0.55}));
  EXPECT_FALSE(view.shows({1, 0, 0.2 - 0.6}));
  EXPECT_FALSE(view.shows({0.01, 0, 0.2}));
}

TEST(ViewFrustumTest, aPartIsTheMiddleOfTheImage) {
  const ViewFrustum view(cameraAhead());
  EXPECT_TRUE(view.shows({1, 0.45, 0.2}, 0.5));
  EXPECT_FALSE(view.shows({1, 0.55, 0.2}, 0.5));
}

TEST(ViewFrustumTest, aCameraWithoutAnglesShowsNothing) {
  EXPECT_FALSE(ViewFrustum(robotcontrol::CameraPose()).shows({1, 0, 0}));
}

}  // namespace
}  // namespace robotlink
