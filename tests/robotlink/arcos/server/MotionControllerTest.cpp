// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/MotionController.h"

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <limits>

#include "robotlink/base/Random.h"
#include "tests/robotlink/arcos/IdealWheels.h"

namespace {

using namespace robotlink;
using namespace robotlink::arcos;

class MotionControllerTest : public testing::Test {
 protected:
  MotionController controller;
  IdealWheels ideal;
  double fastest = 0, fastestTurn = 0;

  MotionControllerTest() { controller.enable(true); }

  double speed() const { return (ideal.command.left + ideal.command.right) / 2; }
  double turning() const {
    return (ideal.command.right - ideal.command.left) / controller.parameters().track;
  }
  void run(double time) {
    for (Duration passed{}; passed < fromSeconds(time); passed += IdealWheels::kStep) {
      ideal.obey(controller.step(ideal.wheels, IdealWheels::kStep));
      fastest = std::max(fastest, std::abs(speed()));
      fastestTurn = std::max(fastestTurn, std::abs(turning()));
    }
  }
};

TEST_F(MotionControllerTest, speedGoesUpAndDownAlongATrapeze) {
  controller.setAcceleration(0.2);
  controller.setDeceleration(0.4);
  controller.translate(0.5);
  run(1);
  EXPECT_NEAR(speed(), 0.2, 1e-3);
  run(1);
  EXPECT_NEAR(speed(), 0.4, 1e-3);
  run(1);
  EXPECT_DOUBLE_EQ(speed(), 0.5);
  EXPECT_TRUE(controller.moving());
  controller.translate(0);
  run(0.5);
  EXPECT_NEAR(speed(), 0.3, 2e-3);
  run(1);
  EXPECT_DOUBLE_EQ(speed(), 0);
  EXPECT_FALSE(controller.moving());
}

TEST_F(MotionControllerTest, aReversalBrakesFirstAndThenAccelerates) {
  controller.setAcceleration(0.1);
  controller.setDeceleration(0.5);
  controller.translate(0.2);
  run(3);
  controller.translate(-0.2);
  run(0.4);
  EXPECT_NEAR(speed(), 0, 2e-3);
  run(1);
  EXPECT_NEAR(speed(), -0.1, 2e-3);
}

TEST_F(MotionControllerTest, positiveIsForwardsAndCounterClockwise) {
  controller.translate(0.3);
  run(2);
  EXPECT_GT(controller.odometry().x, 0.2);
  controller.stop();
  run(2);
  controller.rotate(radians(20.0));
  run(2);
  EXPECT_GT(controller.odometry().heading, radians(20.0));
  EXPECT_LT(ideal.command.left, 0);
  EXPECT_GT(ideal.command.right, 0);
  controller.rotate(radians(-20.0));
  run(6);
  EXPECT_LT(controller.odometry().heading, 0);
}

TEST_F(MotionControllerTest, theEffectiveTrackTurnsRimsIntoHeading) {
  controller.step(ideal.wheels, IdealWheels::kStep);
  ideal.wheels.leftTravel = -0.588 * kPi / 4;
  ideal.wheels.rightTravel = 0.588 * kPi / 4;
  controller.step(ideal.wheels, IdealWheels::kStep);
  EXPECT_NEAR(controller.odometry().heading, kPi / 2, 1e-9);
}

TEST_F(MotionControllerTest, aSpeedLimitHoldsForCommandsThatFollow) {
  controller.translate(0.6);
  controller.setSpeed(0.2);
  run(4);
  EXPECT_DOUBLE_EQ(speed(), 0.6);
  controller.translate(0.6);
  run(4);
  EXPECT_DOUBLE_EQ(speed(), 0.2);
  controller.setSpeed(100);
  controller.setAcceleration(1);
  controller.translate(100);
  run(4);
  EXPECT_DOUBLE_EQ(speed(), MotionParameters().speedTop);
}

TEST_F(MotionControllerTest, zeroAndNonsenseLeaveALimitAsItIs) {
  const MotionParameters before = controller.parameters();
  controller.setSpeed(0);
  controller.setRotation(std::numeric_limits<double>::quiet_NaN());
  controller.setAcceleration(std::numeric_limits<double>::infinity());
  EXPECT_EQ(controller.parameters().speed, before.speed);
  EXPECT_EQ(controller.parameters().rotation, before.rotation);
  EXPECT_EQ(controller.parameters().acceleration, before.acceleration);
  controller.setRotationDeceleration(-0.5);
  EXPECT_EQ(controller.parameters().rotationDeceleration, 0.5);
  controller.restoreParameters();
  EXPECT_EQ(controller.parameters().rotationDeceleration, before.rotationDeceleration);
}

TEST_F(MotionControllerTest, moveEndsAfterItsWay) {
  for (const double distance : {1.0, -0.5, 0.05, -0.004}) {
    const double before = controller.odometry().x;
    fastest = 0;
    controller.setSpeed(0.4);
    controller.move(distance);
    run(8);
    EXPECT_NEAR(controller.odometry().x - before, distance, 0.003) << distance;
    EXPECT_LE(fastest, 0.4 + 1e-9);
    EXPECT_FALSE(controller.moving());
  }
}

TEST_F(MotionControllerTest, moveIsNotHeldOnceItIsDone) {
  controller.move(0.2);
  run(4);
  ideal.wheels.leftTravel += 0.1;  // somebody pushes it
  ideal.wheels.rightTravel += 0.1;
  run(2);
  EXPECT_NEAR(controller.odometry().x, 0.3, 0.005);
}

TEST_F(MotionControllerTest, headTakesTheShorterWayThroughTheWrap) {
  controller.turnTo(radians(170.0));
  run(6);
  EXPECT_NEAR(degrees(controller.odometry().heading), 170, 0.5);
  const double travelBefore = ideal.wheels.rightTravel;
  controller.turnTo(radians(-170.0));
  run(3);
  EXPECT_NEAR(degrees(controller.odometry().heading), -170, 0.5);
  EXPECT_NEAR(ideal.wheels.rightTravel - travelBefore, radians(20.0) * 0.588 / 2, 0.005)
      << "20 degrees on, not 340 back";
  controller.turnTo(radians(530.0));  // 170
  run(3);
  EXPECT_NEAR(degrees(controller.odometry().heading), 170, 0.5);
}

TEST_F(MotionControllerTest, headTurnsNoFasterThanItsLimitAndDoesNotOvershoot) {
  controller.setRotation(radians(30.0));
  controller.turnTo(radians(90.0));
  double most = 0;
  for (int i = 0; i < 2000; ++i) {
    run(0.004);
    most = std::max(most, controller.odometry().heading);
  }
  EXPECT_NEAR(fastestTurn, radians(30.0), 1e-9);
  EXPECT_LT(degrees(most), 90.5);
}

TEST_F(MotionControllerTest, dheadCountsFromTheHeadingAndDcheadFromTheSetpoint) {
  controller.turnTo(radians(90.0));
  run(0.2);
  controller.turnFromSetpoint(radians(30.0));
  run(6);
  EXPECT_NEAR(degrees(controller.odometry().heading), 120, 0.5);
  controller.turnBy(radians(-40.0));
  EXPECT_NEAR(degrees(controller.headingSetpoint()), 80, 0.5);
  run(6);
  EXPECT_NEAR(degrees(controller.odometry().heading), 80, 0.5);
}

TEST_F(MotionControllerTest, speedAndHeadingAreIndependentChannels) {
  controller.translate(0.2);
  controller.turnTo(radians(45.0));
  run(4);
  EXPECT_NEAR(speed(), 0.2, 1e-9);
  EXPECT_NEAR(degrees(controller.odometry().heading), 45, 0.5);
  controller.translate(0.1);
  controller.turnBy(radians(30.0));
  controller.translate(0.15);
  run(4);
  EXPECT_NEAR(degrees(controller.odometry().heading), 75, 0.5) << "VEL does not cancel HEAD";
}

TEST_F(MotionControllerTest, wheelsCancelTheChannelsAndViceVersa) {
  controller.turnTo(radians(90.0));
  controller.driveWheels(0.2, 0.2);
  run(3);
  EXPECT_NEAR(controller.odometry().heading, 0, 1e-9) << "VEL2 cancels HEAD";
  EXPECT_NEAR(speed(), 0.2, 1e-9);
  controller.driveWheels(0.1, 0.2);
  run(3);
  EXPECT_NEAR(ideal.command.left, 0.1, 1e-9);
  EXPECT_NEAR(ideal.command.right, 0.2, 1e-9);
  controller.translate(0.3);
  run(3);
  EXPECT_NEAR(turning(), 0, 1e-9) << "VEL ends the turn that VEL2 asked for";
}

TEST_F(MotionControllerTest, wheelsAreLimitedAsSpeedAndTurn) {
  controller.setSpeed(0.3);
  controller.setRotation(radians(50.0));
  controller.driveWheels(-2, 2.2);
  run(6);
  EXPECT_NEAR(speed(), 0.1, 1e-9);
  EXPECT_NEAR(turning(), radians(50.0), 1e-9);
}

TEST_F(MotionControllerTest, stopBrakesAndEmergencyStopDoesNot) {
  controller.translate(0.5);
  run(3);
  controller.stop();
  run(0.1);
  EXPECT_GT(speed(), 0.4);
  controller.translate(0.5);
  run(3);
  controller.emergencyStop();
  run(0.004);
  EXPECT_EQ(speed(), 0);
  EXPECT_TRUE(controller.motorsOn());
}

TEST_F(MotionControllerTest, withoutMotorsNothingMovesAndNothingIsRemembered) {
  controller.translate(0.3);
  run(2);
  controller.enable(false);
  run(0.1);
  EXPECT_FALSE(ideal.command.motorsOn);
  controller.translate(0.3);
  controller.turnTo(1);
  controller.enable(true);
  run(2);
  EXPECT_EQ(ideal.command, (WheelCommand{0, 0, true}));
}

TEST_F(MotionControllerTest, heldItStopsAndThenGoesOnWithItsCommand) {
  controller.translate(0.3);
  run(2);
  controller.hold(true);
  run(2);
  EXPECT_EQ(speed(), 0);
  controller.hold(false);
  run(2);
  EXPECT_NEAR(speed(), 0.3, 1e-9);
}

TEST_F(MotionControllerTest, aStallTakesThePowerForAMomentAndIsForgottenAfterwards) {
  controller.translate(0.3);
  run(2);
  ideal.wheels.leftBlocked = true;
  run(0.004);
  EXPECT_FALSE(ideal.command.motorsOn);
  EXPECT_TRUE(controller.leftStalled());
  EXPECT_FALSE(controller.rightStalled());
  ideal.wheels.leftBlocked = false;
  run(0.19);
  EXPECT_FALSE(ideal.command.motorsOn);
  run(0.05);
  EXPECT_TRUE(ideal.command.motorsOn) << "they come back by themselves";
  EXPECT_FALSE(controller.leftStalled());
  run(2);
  EXPECT_NEAR(speed(), 0.3, 1e-9);
}

TEST_F(MotionControllerTest, setOdometryMovesTheFrameButNotTheEndOfATurn) {
  controller.turnTo(radians(60.0));
  run(0.5);
  const double turned = controller.odometry().heading;
  controller.setOdometry({});
  EXPECT_EQ(controller.odometry(), Pose2{});
  run(5);
  EXPECT_NEAR(controller.odometry().heading, radians(60.0) - turned, 0.01);
}

TEST_F(MotionControllerTest, aGyroscopeTakesThePlaceOfTheWheelsForTheHeading) {
  ideal.wheels.rotationRate = 0.5;
  controller.translate(0.1);
  run(2);
  EXPECT_NEAR(controller.odometry().heading, 1.0, 0.01);
}

TEST_F(MotionControllerTest, anyCommandsInAnyOrderStayWithinTheLimits) {
  Random random(7);
  const double tops = MotionParameters().speedTop + MotionParameters().rotationTop * 0.588 / 2;
  const std::function<void(double)> commands[] = {
      [&](double value) { controller.translate(value); },
      [&](double value) { controller.rotate(value); },
      [&](double value) { controller.turnTo(value); },
      [&](double value) { controller.turnBy(value); },
      [&](double value) { controller.turnFromSetpoint(value); },
      [&](double value) { controller.move(value); },
      [&](double value) { controller.driveWheels(value, -value / 3); },
      [&](double value) { controller.setSpeed(value); },
      [&](double value) { controller.setRotation(value); },
      [&](double value) { controller.setAcceleration(value); },
      [&](double value) { controller.setRotationDeceleration(value); },
      [&](double) { controller.enable(random.uniform() < 0.9); },
      [&](double) { controller.hold(random.uniform() < 0.2); },
      [&](double value) {
        controller.setOdometry({value, value, value});
      },
      [&](double) { ideal.wheels.leftBlocked = random.uniform() < 0.1; },
      [&](double) { controller.stop(); }};
  for (int i = 0; i < 20000; ++i) {
    const double value =
        random.uniform() < 0.05 ? std::numeric_limits<double>::infinity() : random.uniform(-70, 70);
    commands[random.bits() % std::size(commands)](value);
    run(0.004);
    ASSERT_LE(std::abs(ideal.command.left), tops);
    ASSERT_LE(std::abs(ideal.command.right), tops);
    ASSERT_TRUE(std::isfinite(controller.odometry().x + controller.odometry().y));
    ASSERT_LE(std::abs(controller.odometry().heading), kPi);
    ASSERT_LE(std::abs(controller.headingSetpoint()), kPi);
  }
}

}  // namespace
