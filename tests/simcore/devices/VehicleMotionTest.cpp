// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/VehicleMotion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robotlink/base/Geometry.h"

namespace simcore {
namespace {

using Command = std::array<double, 6>;

GuidedMotion motionOfKind(GuidedMotion::Kind kind) {
  GuidedMotion motion;
  motion.kind = kind;
  motion.maximumSpeed = 2;
  motion.track = 0.5;
  motion.wheelbase = 0.4;
  motion.skid = 0.5;
  return motion;
}

VehicleWheel wheelAt(double x, double y) {
  VehicleWheel wheel;
  wheel.center = {x, y, 0};
  return wheel;
}

/// Wheels at the corners of 0.6 x 0.4 m whose rollers push towards the middle, as seen from above.
VehicleDescription mecanumVehicle() {
  VehicleDescription vehicle;
  for (const double x : {0.3, -0.3}) {
    for (const double y : {0.2, -0.2}) {
      VehicleWheel wheel = wheelAt(x, y);
      wheel.rollers = x * y > 0 ? -robotlink::kPi / 4 : robotlink::kPi / 4;
      vehicle.wheels.push_back(wheel);
    }
  }
  return vehicle;
}

TEST(VehicleMotion, theSpeedsOfTwoSidesDriveByTheirMeanAndTurnByTheirDifference) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kDifferential);
  const PlaneMotion moved = motionOf(motion, nullptr, Command{0.2, 0.4});
  EXPECT_DOUBLE_EQ(moved.ahead, 0.3);
  EXPECT_EQ(moved.sideways, 0);
  EXPECT_DOUBLE_EQ(moved.turning, 0.4) << "to the left, because the right side is faster";
  EXPECT_DOUBLE_EQ(motionOf(motion, nullptr, Command{-1, 1}).ahead, 0);
}

TEST(VehicleMotion, onlyAModelWithoutWheelsIsSlowedByItsSkid) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kSkid);
  const VehicleDescription vehicle;
  EXPECT_DOUBLE_EQ(motionOf(motion, nullptr, Command{-0.1, 0.1}).turning, 0.2);
  EXPECT_DOUBLE_EQ(motionOf(motion, &vehicle, Command{-0.1, 0.1}).turning, 0.4);
}

TEST(VehicleMotion, aSteeredAxleTurnsAVehicleTheOtherWayWhenItReverses) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kAckermann);
  const double radius = 0.4 / std::tan(0.5);
  EXPECT_DOUBLE_EQ(motionOf(motion, nullptr, Command{1, 0.5}).turning, 1 / radius);
  EXPECT_DOUBLE_EQ(motionOf(motion, nullptr, Command{-1, 0.5}).turning, -1 / radius);
  EXPECT_EQ(motionOf(motion, nullptr, Command{0, 0.5}).turning, 0) << "a vehicle that stands does not turn";
}

TEST(VehicleMotion, theAxlesOfSteeredWheelsMeetInTheCenterOfTheTurn) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kAckermann);
  for (const double commanded : {0.5, -0.3}) {
    const robotlink::Vector2 center(0, 0.4 / std::tan(commanded));
    for (const VehicleWheel& wheel : {wheelAt(0.4, 0.2), wheelAt(0.4, -0.2), wheelAt(-0.1, 0.2)}) {
      const double angle = steeringAngle(motion, wheel, commanded);
      const robotlink::Vector2 rolling(std::cos(angle), std::sin(angle));
      const robotlink::Vector2 toCenter = center - wheel.center.head<2>();
      EXPECT_NEAR(rolling.dot(toCenter), 0, 1e-12) << wheel.center.transpose() << " at " << commanded;
    }
  }
}

TEST(VehicleMotion, theInnerWheelIsSteeredMoreThanTheOuterOneAndAMiddleOneAsCommanded) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kAckermann);
  const double left = steeringAngle(motion, wheelAt(0.4, 0.2), 0.5);
  const double right = steeringAngle(motion, wheelAt(0.4, -0.2), 0.5);
  EXPECT_GT(left, 0.5);
  EXPECT_LT(right, 0.5);
  EXPECT_DOUBLE_EQ(steeringAngle(motion, wheelAt(0.4, 0), 0.5), 0.5);
  EXPECT_DOUBLE_EQ(steeringAngle(motion, wheelAt(0.4, 0.2), -0.5), -right);
  EXPECT_EQ(steeringAngle(motion, wheelAt(0.4, 0.2), 0), 0);
}

TEST(VehicleMotion, wheelsOfASteeredVehicleRollByTheirDistanceFromTheCenterOfTheTurn) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kAckermann);
  VehicleDescription vehicle;
  vehicle.wheels = {wheelAt(0.4, 0.2), wheelAt(0.4, -0.2), wheelAt(0, 0.2), wheelAt(0, -0.2)};
  vehicle.wheels[0].steering = vehicle.wheels[1].steering = 0;
  const robotlink::Vector2 center(0, 0.4 / std::tan(0.5));
  for (const VehicleWheel& wheel : vehicle.wheels) {
    const double distance = (wheel.center.head<2>() - center).norm();
    EXPECT_NEAR(rimSpeed(motion, vehicle, wheel, Command{1, 0.5}), distance / center.y(), 1e-12)
        << wheel.center.transpose();
  }
}

TEST(VehicleMotion, aWheelTurnsWithItsSideAndOneWithoutAMotorIsNotCommanded) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kSkid);
  VehicleDescription vehicle;
  vehicle.wheels = {wheelAt(0.2, 0.25), wheelAt(-0.2, -0.25), wheelAt(-0.4, 0.1)};
  vehicle.wheels[2].driven = false;
  const Command command{0.3, -0.7};
  EXPECT_EQ(rimSpeed(motion, vehicle, vehicle.wheels[0], command), 0.3);
  EXPECT_EQ(rimSpeed(motion, vehicle, vehicle.wheels[1], command), -0.7);
  EXPECT_EQ(rimSpeed(motion, vehicle, vehicle.wheels[2], command), 0);
}

TEST(VehicleMotion, mecanumWheelsTurnAsTheirTextbooksSay) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kOmni);
  const VehicleDescription vehicle = mecanumVehicle();
  const double ahead = 0.5, sideways = 0.2, turning = 0.4, lever = 0.3 + 0.2;
  const Command command{ahead, sideways, turning};
  // Front left, front right, rear left, rear right.
  const double expected[] = {ahead - sideways - lever * turning, ahead + sideways + lever * turning,
                             ahead + sideways - lever * turning, ahead - sideways + lever * turning};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(rimSpeed(motion, vehicle, vehicle.wheels[i], command), expected[i], 1e-12) << i;
}

TEST(VehicleMotion, anOmnidirectionalVehicleKeepsItsDirectionWhenAWheelIsAtItsLimit) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kOmni);
  const VehicleDescription vehicle = mecanumVehicle();
  // The fastest wheels would turn at 4.5 m/s.
  const Command limited = limitedCommand(motion, vehicle, Command{3, 1, 1});
  EXPECT_DOUBLE_EQ(limited[0], 3 * 2 / 4.5);
  EXPECT_DOUBLE_EQ(limited[1], 1 * 2 / 4.5);
  EXPECT_DOUBLE_EQ(limited[2], 1 * 2 / 4.5);
  const Command slow{0.3, -0.2, 0.5};
  EXPECT_EQ(limitedCommand(motion, vehicle, slow), slow);
  EXPECT_EQ(limitedCommand(motion, VehicleDescription{}, Command{9, 9, 9}), (Command{9, 9, 9}))
      << "without wheels nothing limits it here";
}

TEST(VehicleMotion, eachSideOfADifferentialDriveHasItsLimit) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kDifferential);
  EXPECT_EQ(limitedCommand(motion, {}, Command{5, -1}), (Command{2, -1}));
  EXPECT_EQ(limitedCommand(motion, {}, Command{-5, 7}), (Command{-2, 2}));
}

TEST(VehicleMotion, speedAndSteeringAreLimitedByThemselves) {
  const GuidedMotion motion = motionOfKind(GuidedMotion::Kind::kAckermann);
  EXPECT_EQ(limitedCommand(motion, {}, Command{-5, 1.5}), (Command{-2, 0.6}));
  EXPECT_EQ(limitedCommand(motion, {}, Command{1, -1.5}), (Command{1, -0.6}));
}

TEST(VehicleMotion, torquesAreNotLimitedAsIfTheyWereSpeeds) {
  VehicleDescription vehicle;
  vehicle.byTorque = true;
  const GuidedMotion sides = motionOfKind(GuidedMotion::Kind::kDifferential);
  EXPECT_EQ(limitedCommand(sides, vehicle, Command{20, -30}), (Command{20, -30}));
  const GuidedMotion steered = motionOfKind(GuidedMotion::Kind::kAckermann);
  EXPECT_EQ(limitedCommand(steered, vehicle, Command{20, 1}), (Command{20, 0.6}))
      << "the steering angle is still one";
}

}  // namespace
}  // namespace simcore
