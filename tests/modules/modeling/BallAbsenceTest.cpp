// SPDX-License-Identifier: GPL-3.0-or-later
// A ball that is not where an image should show it is forgotten.
#include <gtest/gtest.h>

#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/modules/OneSolution.h"

namespace modules {
namespace {

const OneSolution::Robot kAiboOnAField{
    .map = nullptr, .name = "red1", .description = "ers210.yaml", .field = "2002.yaml"};
constexpr int kAbsentImages = 10;  // as in the files of parameters

class BallAbsence : public testing::TestWithParam<const char*> {
 protected:
  BallAbsence() {
    robotlink::Pose3 pose = robotlink::Pose3::Identity();
    pose.translation() = robotlink::Vector3(0, 0, 0.2);
    robotlink::assign(*camera_.mutable_camera_in_robot(), pose);
    camera_.set_horizontal_angle(1);
    camera_.set_vertical_angle(0.8);
  }
  void image(bool seen, double x = 0, double y = 0) {
    solution_.pass(0.04);
    robotcontrol::BallPercept percept;
    robotlink::assign(*percept.mutable_timestamp(), solution_.clock().now());
    percept.set_seen(seen);
    percept.set_confidence(seen ? 1 : 0);
    percept.mutable_position_in_robot()->set_x(x);
    percept.mutable_position_in_robot()->set_y(y);
    solution_.set(robotlink::kCameraPose, camera_);
    solution_.set(robotlink::kBallPercept, percept);
    solution_.execute();
  }
  bool known() { return solution_.sent(robotlink::kBallModel)->known(); }

  OneSolution solution_{"ball-model", GetParam(), kAiboOnAField};
  robotcontrol::CameraPose camera_;
};

TEST_P(BallAbsence, aBallThatIsNotWhereTheCameraLooksIsForgotten) {
  for (int i = 0; i < 5; ++i) image(true, 1, 0);
  ASSERT_TRUE(known());
  for (int i = 1; i < kAbsentImages; ++i) image(false);
  EXPECT_TRUE(known());
  image(false);
  EXPECT_FALSE(known());
  image(true, 0.8, 0.2);
  EXPECT_TRUE(known());
  EXPECT_NEAR(solution_.sent(robotlink::kBallModel)->position_in_robot().x(), 0.8, 0.1);
}

TEST_P(BallAbsence, aBallBesideTheImageOrVeryNearIsRemembered) {
  for (int i = 0; i < 5; ++i) image(true, 0.5, 1);
  for (int i = 0; i < 3 * kAbsentImages; ++i) image(false);
  EXPECT_TRUE(known());
  for (int i = 0; i < 5; ++i) image(true, 0.2, 0);
  for (int i = 0; i < 3 * kAbsentImages; ++i) image(false);
  EXPECT_TRUE(known());
}

INSTANTIATE_TEST_SUITE_P(All, BallAbsence, testing::Values("kalman", "particle"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace modules
