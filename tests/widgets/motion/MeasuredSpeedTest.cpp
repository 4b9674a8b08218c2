// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MeasuredSpeed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foxglove/Geometry.pb.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

using robotlink::Instant;
using robotlink::Pose2;

class MeasuredSpeedTest : public testing::Test {
 protected:
  void put(double time, const Pose2& pose, const std::string& model = "red1") {
    auto transforms = std::make_shared<foxglove::FrameTransforms>();
    auto& transform = *transforms->add_transforms();
    transform.set_child_frame_id(model);
    transform.set_parent_frame_id("field");
    transform.mutable_translation()->set_x(pose.x);
    transform.mutable_translation()->set_y(pose.y);
    transform.mutable_rotation()->set_z(std::sin(pose.heading / 2));
    transform.mutable_rotation()->set_w(std::cos(pose.heading / 2));
    session.push({"transforms", Instant(robotlink::fromSeconds(time)), transforms});
    session.tick();
  }
  std::optional<Speed> measured(double time) {
    return measuredSpeed(session.store(), "red1", Instant(robotlink::fromSeconds(time)));
  }
  robotlink::Session session;
};

TEST_F(MeasuredSpeedTest, isInTheRobotsOwnFrame) {
  // Looks along y and drives there, and a bit to its right.
  for (int i = 0; i <= 20; ++i) put(0.1 * i, {0.002 * i, 0.03 * i, robotlink::kPi / 2});
  const auto speed = measured(2);
  ASSERT_TRUE(speed);
  EXPECT_NEAR(speed->x, 0.3, 1e-6);
  EXPECT_NEAR(speed->y, -0.02, 1e-6);
  EXPECT_NEAR(speed->rotation, 0, 1e-6);
}

TEST_F(MeasuredSpeedTest, beingPlacedElsewhereIsNoSpeed) {
  for (int i = 0; i <= 20; ++i) put(0.1 * i, {i < 11 ? 2.0 : 0.01 * i, 0, 0});
  EXPECT_FALSE(measured(1.1)) << "nothing is known yet of where it is now";
  const auto speed = measured(2);
  ASSERT_TRUE(speed);
  EXPECT_NEAR(speed->x, 0.1, 1e-6);
}

TEST_F(MeasuredSpeedTest, onACircleIsThatAlongIt) {
  constexpr double kRate = 1.2, kRadius = 0.5;  // rad/s, m
  for (int i = 0; i <= 60; ++i) {
    const double angle = 0.1 * i * kRate;
    put(0.1 * i, {kRadius * std::sin(angle), -kRadius * std::cos(angle), angle});
  }
  // Also where the heading jumps from pi to -pi.
  for (const double time : {1.0, 2.618, 2.8, 3.0, 5.3}) {
    const auto speed = measured(time);
    ASSERT_TRUE(speed) << time;
    EXPECT_NEAR(speed->x, kRate * kRadius, 0.02) << time;
    EXPECT_NEAR(speed->y, 0, 0.02) << time;
    EXPECT_NEAR(speed->rotation, kRate, 1e-6) << time;
  }
}

TEST_F(MeasuredSpeedTest, isThatAtTheInstantThatIsShown) {
  for (int i = 0; i <= 20; ++i) put(0.1 * i, {i <= 10 ? 0.05 * i : 0.5, 0, 0});
  EXPECT_NEAR(measured(1)->x, 0.5, 1e-6);
  EXPECT_NEAR(measured(2)->x, 0, 1e-6);
}

TEST_F(MeasuredSpeedTest, isNotKnownAfterTooShortATime) {
  EXPECT_FALSE(measured(1)) << "nobody publishes poses";
  put(0, {0, 0, 0});
  EXPECT_FALSE(measured(1));
  put(0.1, {0.1, 0, 0});
  EXPECT_FALSE(measured(1)) << "less than half of the window";
  put(0.3, {0.3, 0, 0});
  EXPECT_NEAR(measured(1)->x, 1, 1e-6);
}

TEST_F(MeasuredSpeedTest, isNotThatOfAnother) {
  for (int i = 0; i <= 20; ++i) put(0.1 * i, {0.1 * i, 0, 0}, "blue1");
  EXPECT_FALSE(measured(2));
}

}  // namespace
}  // namespace widgets
