// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/StateDecoder.h"

#include <gmock/gmock.h>

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;

struct StateDecoderTest : testing::Test {
  const RobotState& take(const StandardInformation& information) {
    decoder.take(information, now += 100ms);
    return decoder.state();
  }
  const Pose2& at(int xMm, int yMm) {
    StandardInformation information;
    information.xMm = static_cast<std::int16_t>(xMm);
    information.yMm = static_cast<std::int16_t>(yMm);
    return take(information).pose;
  }

  StateDecoder decoder{robotType("p3at-sh")};
  Instant now{10s};
};

TEST_F(StateDecoderTest, numbersOfThePacketBecomeSi) {
  StandardInformation i;
  i.moving = true;
  i.heading4096 = -1024;
  i.leftSpeedMmS = 100;
  i.rightSpeedMmS = 300;
  i.batteryDecivolts = 127;
  i.flags = StandardInformation::kMotorsOn | StandardInformation::kSonarArray1On |
            StandardInformation::kEmergencyStop;
  i.stallAndBumpers =
      StandardInformation::kRightStalled | 1U << 10U | 1U << 3U;  // front segment 1, rear segment 2
  i.digitalIn = 3;
  i.temperatureDegC = std::int8_t{31};
  i.stateOfChargePercent = std::uint8_t{80};
  i.chargeState = std::uint8_t{1};
  const RobotState& s = take(i);
  EXPECT_EQ(s.time, now);
  EXPECT_NEAR(s.pose.heading, -kPi / 2, 1e-9);
  EXPECT_NEAR(s.speed, 0.2, 1e-9);
  EXPECT_NEAR(s.leftSpeed, 0.1, 1e-9);
  EXPECT_NEAR(s.rotation, 0.2 / 0.588, 1e-9) << "from the wheels, where no gyroscope says it";
  EXPECT_TRUE(s.moving && s.motorsOn && s.sonarOn && s.emergencyStop);
  EXPECT_TRUE(s.stalled() && s.rightStalled && !s.leftStalled);
  EXPECT_EQ(s.frontBumpers, 0b10);
  EXPECT_EQ(s.rearBumpers, 0b100);
  EXPECT_TRUE(s.bumped());
  EXPECT_NEAR(s.battery, 12.7, 1e-9);
  EXPECT_EQ(s.digitalIn, 3);
  EXPECT_EQ(s.temperature, 31.0);
  EXPECT_EQ(s.stateOfCharge, 0.8);
  EXPECT_EQ(s.charging, true);

  i.rotationRateDeciDegS = std::int16_t{-100};
  EXPECT_NEAR(take(i).rotation, radians(-10.0), 1e-9);
}

TEST_F(StateDecoderTest, whatAnOldRobotDoesNotSendIsUnknown) {
  const RobotState& s = take({});
  EXPECT_FALSE(s.temperature || s.stateOfCharge || s.charging);
  EXPECT_FALSE(s.moving || s.motorsOn || s.bumped() || s.stalled());
}

TEST_F(StateDecoderTest, odometryDoesNotWrapHoweverWideTheCounterIs) {
  for (const int width : {1 << 15, 1 << 16}) {
    decoder = StateDecoder(robotType("p3at-sh"));
    double expected = 0;
    for (int xMm = 0; xMm < 100'000; xMm += 90, expected += 0.09) {
      ASSERT_NEAR(at(xMm % width, -(xMm % width)).x, expected, 1e-6) << width;
      ASSERT_NEAR(decoder.state().pose.y, -expected, 1e-6) << width;
    }
  }
}

TEST_F(StateDecoderTest, odometryBeginsWhereTheRobotSaysItIs) {
  EXPECT_NEAR(at(-1500, 20).x, -1.5, 1e-9);
  EXPECT_NEAR(at(-1600, 20).x, -1.6, 1e-9);
}

TEST_F(StateDecoderTest, aResetThatIsExpectedIsNoWay) {
  at(32'700, 0);
  at(32'700 + 100 - 65'536, 0);  // wrapped: at 32.8 m
  EXPECT_NEAR(decoder.state().pose.x, 32.8, 1e-6);
  decoder.expectReset(now);
  EXPECT_NEAR(at(32'900 - 65'536, 0).x, 32.9, 1e-6) << "a packet from before it";
  EXPECT_NEAR(at(12, 0).x, 0.012, 1e-6);
  EXPECT_NEAR(at(112, 0).x, 0.112, 1e-6);
  for (int i = 0; i < 10; ++i) at(112, 0);
  EXPECT_NEAR(at(62, 0).x, 0.062, 1e-6);
}

TEST_F(StateDecoderTest, sonarsKeepTheirLatestRange) {
  EXPECT_EQ(decoder.state().sonars.size(), 16u);
  EXPECT_FALSE(decoder.state().sonars[3].echo);
  StandardInformation first;
  first.xMm = 1000;
  first.sonars = {{3, 1500}, {11, 5000}, {40, 7}};
  take(first);
  StandardInformation second;
  second.sonars = {{11, 900}};
  const RobotState& s = take(second);
  EXPECT_NEAR(s.sonars[3].range, 1.5, 1e-9);
  EXPECT_TRUE(s.sonars[3].echo);
  EXPECT_EQ(s.sonars[3].time, now - 100ms);
  EXPECT_NEAR(s.sonars[3].robot.x, 1.0, 1e-9);
  EXPECT_NEAR(s.sonars[11].range, 0.9, 1e-9);
  EXPECT_NEAR(s.sonars[5].range, 5.0, 1e-9) << "never measured: nothing is known to be there";
  const Vector2 point = s.sonars[3].pointInRobot();
  EXPECT_NEAR(point.x(), 0.245 + 1.5 * std::cos(radians(10.0)), 1e-6);
  EXPECT_NEAR(point.y(), 0.027 + 1.5 * std::sin(radians(10.0)), 1e-6);
}

TEST_F(StateDecoderTest, theGripperIsAsItsBitsSay) {
  EXPECT_FALSE(take({}).gripper) << "an older robot sends nothing of it";
  StandardInformation information;
  information.gripState = std::uint8_t{0b0101'0001};
  const GripperState expected{.open = true, .liftUp = true, .liftMoving = true};
  EXPECT_EQ(take(information).gripper, expected);
}

TEST_F(StateDecoderTest, aRobotWithAnOlderControllerCountsSmallerSteps) {
  decoder = StateDecoder(robotType("p3at"));
  EXPECT_NEAR(at(1000, 0).x, 0.465, 1e-9);
}

}  // namespace
}  // namespace robotlink::arcos
