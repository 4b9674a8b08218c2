// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/WheelModelGait.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::Vector3;
constexpr robotlink::Duration kFrame = std::chrono::milliseconds(8);

void run(WheelModelGait& gait, const WalkSpeed& speed, int frames) {
  gait.request(speed);
  for (int i = 0; i < frames; ++i) gait.advance(kFrame, WheelModelGait::Idle::kStand);
}

/// Velocity of a paw over the body in the next frame, if it stays on the ground.
Vector3 groundVelocity(WheelModelGait gait, Leg leg) {
  const Vector3 before = gait.pawInBody(leg);
  gait.advance(kFrame, WheelModelGait::Idle::kStep);
  return (gait.pawInBody(leg) - before) / 0.008;
}

WheelModelGait levelGait() {
  GaitParameters parameters;
  parameters.foreHeight = parameters.hindHeight = 0.1;
  parameters.foreWidth = parameters.hindWidth = 0.075;
  parameters.foreCenterX = 0.03;
  parameters.hindCenterX = -0.03;
  parameters.factorX = parameters.factorBackward = parameters.factorY = parameters.factorRotation = 1;
  parameters.counterRotationX = parameters.counterRotationY = parameters.hindShiftBackward = 0;
  return WheelModelGait(parameters);
}

TEST(WheelModelGaitTest, pawsOnTheGroundMoveLikeWheels) {
  WheelModelGait gait = levelGait();
  const WalkSpeed speed{0.05, 0.03, 0.4};
  run(gait, speed, 100);
  for (int i = 0; i < 50; ++i) {
    gait.advance(kFrame, WheelModelGait::Idle::kStep);
    for (const Leg leg : kLegs) {
      WheelModelGait next = gait;
      next.advance(kFrame, WheelModelGait::Idle::kStep);
      if (!gait.onGround(leg) || !next.onGround(leg) || next.phase() < gait.phase()) continue;
      const Vector3 velocity = groundVelocity(gait, leg);
      const double x = isFore(leg) ? 0.0895 : -0.0895, y = isLeft(leg) ? 0.075 : -0.075;
      EXPECT_NEAR(velocity.x(), -(speed.x - speed.rotation * y), 1e-6);
      EXPECT_NEAR(velocity.y(), -(speed.y + speed.rotation * x), 1e-6);
      EXPECT_NEAR(velocity.z(), 0, 1e-9);
    }
  }
}

TEST(WheelModelGaitTest, aDriftAheadIsCounteredUnlessTheRobotWalksAheadAnyway) {
  GaitParameters parameters;
  parameters.counterForwardRotation = 0.03;
  parameters.counterForwardSideways = 2;
  parameters.counterForwardUntil = 0.1;
  const auto stepOfFrontPaws = [&](const WalkSpeed& speed) {
    WheelModelGait gait(parameters);
    run(gait, speed, 100);
    return 0.5 * (gait.stepVector(Leg::kFrontLeft) + gait.stepVector(Leg::kFrontRight)).x();
  };
  const double seconds = parameters.stepFrames * 0.008 * parameters.groundPhase[0];
  EXPECT_NEAR(stepOfFrontPaws({0, 0, 1}) / seconds, -0.03, 1e-9);
  EXPECT_NEAR(stepOfFrontPaws({0, 0.1, 0}) / seconds, -0.02, 1e-9);
  const double ahead = stepOfFrontPaws({0.1, 0, 0});
  EXPECT_NEAR(stepOfFrontPaws({0.1, 0.02, 0.2}), ahead, 1e-9);
}

TEST(WheelModelGaitTest, diagonalLegsAreOnTheGroundTogether) {
  WheelModelGait gait = levelGait();
  run(gait, {0.1, 0, 0}, 60);
  for (int i = 0; i < 50; ++i) {
    gait.advance(kFrame, WheelModelGait::Idle::kStep);
    EXPECT_EQ(gait.onGround(Leg::kFrontLeft), gait.onGround(Leg::kHindRight));
    EXPECT_EQ(gait.onGround(Leg::kFrontRight), gait.onGround(Leg::kHindLeft));
    EXPECT_NE(gait.onGround(Leg::kFrontLeft), gait.onGround(Leg::kFrontRight));
  }
}

TEST(WheelModelGaitTest, speedsChangeStepByStep) {
  WheelModelGait gait = levelGait();
  gait.request({0.15, 0, 0});
  for (int i = 0; i < 100; ++i) {
    const double before = gait.speed().x;
    gait.advance(kFrame, WheelModelGait::Idle::kStand);
    EXPECT_LE(gait.speed().x - before, gait.parameters().maximumChangeX * 0.008 + 1e-12);
  }
  EXPECT_DOUBLE_EQ(gait.speed().x, 0.15);
}

TEST(WheelModelGaitTest, tooMuchIsShrunkInItsDirection) {
  const WheelModelGait gait = levelGait();
  const WalkSpeed speed = gait.limited({1.8, 0, 0});
  EXPECT_DOUBLE_EQ(speed.x, gait.parameters().maximumX);
  const WalkSpeed both = gait.limited({1, 1, 5});
  EXPECT_NEAR(both.y / both.x, 1, 1e-12);
  EXPECT_NEAR(both.rotation / both.x, 5, 1e-12);
  EXPECT_EQ(gait.limited({0.1, 0, 0.1}), (WalkSpeed{0.1, 0, 0.1}));
  EXPECT_EQ(gait.limited({NAN, 0, 0}), WalkSpeed{});
}

TEST(WheelModelGaitTest, aStopEndsWithAllPawsDownAtTheirPlaces) {
  WheelModelGait gait = levelGait();
  run(gait, {0.1, 0.02, 0.2}, 117);
  run(gait, {}, 100);
  EXPECT_TRUE(gait.standing());
  for (const Leg leg : kLegs) {
    EXPECT_NEAR(gait.pawInBody(leg).z(), -0.1, 1e-12);
    EXPECT_NEAR(std::abs(gait.pawInBody(leg).x()), 0.0895, 1e-12);
    EXPECT_TRUE(gait.onGround(leg));
  }
}

TEST(WheelModelGaitTest, pawsNeverJump) {
  GaitParameters parameters;
  for (const FootMode mode : {FootMode::kRectangle, FootMode::kHalfEllipse}) {
    parameters.footMode = mode;
    WheelModelGait gait(parameters);
    std::array<Vector3, 4> last{};
    for (const Leg leg : kLegs) last[index(leg)] = gait.pawInBody(leg);
    for (int i = 0; i < 600; ++i) {
      gait.request(i % 170 < 90 ? WalkSpeed{0.1, -0.05, 0.3} : WalkSpeed{});
      gait.advance(kFrame, WheelModelGait::Idle::kStand);
      for (const Leg leg : kLegs) {
        EXPECT_LT((gait.pawInBody(leg) - last[index(leg)]).norm(), 0.012) << i;
        last[index(leg)] = gait.pawInBody(leg);
      }
    }
  }
}

TEST(WheelModelGaitTest, longerHindLegsPitchTheBody) {
  GaitParameters parameters;
  parameters.foreHeight = 0.09;
  parameters.hindHeight = 0.11;
  const WheelModelGait gait(parameters);
  // The plane through all paws is the ground: it is sloped against the body by the pitch.
  const Vector3 fore = gait.pawInBody(Leg::kFrontLeft), hind = gait.pawInBody(Leg::kHindLeft);
  EXPECT_NEAR((fore.z() - hind.z()) / (fore.x() - hind.x()), std::tan(std::asin(0.02 / 0.119)), 1e-9);
}

}  // namespace
}  // namespace modules
