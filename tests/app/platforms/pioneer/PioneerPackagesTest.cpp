// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerPackages.h"

#include <gtest/gtest.h>

#include "robotlink/arcos/StateDecoder.h"
#include "robotlink/base/Resources.h"
#include "robotlink/packages/Conversions.h"

using namespace app;
using robotlink::Instant;
using robotlink::arcos::StandardInformation;
using std::chrono::milliseconds;

namespace {

const robotlink::RobotDescription& pioneer() {
  static const auto description = robotlink::readRobotDescription(robotlink::resource("robots/p3at.yaml"));
  EXPECT_TRUE(description) << robotlink::describe(description.error());
  return *description;
}

StandardInformation informationAt(int xMm, int yMm, int heading4096) {
  StandardInformation information;
  information.xMm = static_cast<std::int16_t>(xMm);
  information.yMm = static_cast<std::int16_t>(yMm);
  information.heading4096 = static_cast<std::int16_t>(heading4096);
  return information;
}

class PioneerPackagesTest : public testing::Test {
 protected:
  robotcontrol::DriveState state(const StandardInformation& information) {
    time_ += milliseconds(100);
    decoder_.take(information, time_);
    return *packages_.state(decoder_.state(), information, time_);
  }
  void restart() {
    decoder_ = robotlink::arcos::StateDecoder(decoder_.type());
    packages_.restart();
  }
  Instant time_;
  robotlink::arcos::StateDecoder decoder_{robotlink::arcos::robotType({})};
  PioneerPackages packages_{"p3at1", pioneer()};
};

}  // namespace

TEST_F(PioneerPackagesTest, theOdometryBeginsAtZeroAndGoesOnPastSixteenBits) {
  EXPECT_EQ(state(informationAt(32700, 0, 0)).odometry().x(), 0);
  EXPECT_NEAR(state(informationAt(32750, 0, 0)).odometry().x(), 0.05, 1e-9);
  EXPECT_NEAR(state(informationAt(32750 + 100 - 65536, 0, 0)).odometry().x(), 0.15, 1e-9);
}

TEST_F(PioneerPackagesTest, afterAnotherConnectionTheOdometryGoesOnFromWhereItWas) {
  state(informationAt(0, 0, 0));
  state(informationAt(500, 0, 1024));  // a quarter to the left
  restart();
  state(informationAt(0, 0, 0));  // the robot was switched on again
  const auto last = state(informationAt(200, 0, 0)).odometry();
  EXPECT_NEAR(last.x(), 0.5, 1e-9);
  EXPECT_NEAR(last.y(), 0.2, 1e-9);
  EXPECT_NEAR(last.heading(), robotlink::kPi / 2, 1e-9);
}

TEST_F(PioneerPackagesTest, aLeapIsNoWayThatItWent) {
  state(informationAt(0, 0, 0));
  state(informationAt(800, 0, 0));
  state(informationAt(5000, 0, 0));  // somebody has set it
  EXPECT_NEAR(state(informationAt(5100, 0, 0)).odometry().x(), 0.9, 1e-9);
  packages_.resetOdometry();
  EXPECT_NEAR(state(informationAt(5200, 0, 0)).odometry().x(), 0.1, 1e-9);
}

TEST_F(PioneerPackagesTest, theStateOfTheBaseIsInMetersAndRadians) {
  StandardInformation information = informationAt(0, 0, 0);
  information.leftSpeedMmS = 206;
  information.rightSpeedMmS = 794;
  information.batteryDecivolts = 124;
  information.stallAndBumpers = StandardInformation::kRightStalled | (1U << 10U) | (1U << 2U);
  information.flags = StandardInformation::kMotorsOn | StandardInformation::kSonarArray1On;
  information.chargeState = 0;
  information.stateOfChargePercent = 80;
  packages_.setBumpers(5, 5);
  const auto reported = state(information);
  EXPECT_NEAR(reported.velocity().x(), 0.5, 1e-9);
  EXPECT_NEAR(reported.velocity().rotation(), 1.0, 1e-9);
  EXPECT_NEAR(reported.battery(), 12.4, 1e-9);
  EXPECT_TRUE(reported.motors_on());
  EXPECT_TRUE(reported.sonar_on());
  EXPECT_FALSE(reported.left_stalled());
  EXPECT_TRUE(reported.right_stalled());
  ASSERT_EQ(reported.front_bumpers_size(), 5);
  EXPECT_TRUE(reported.front_bumpers(1));
  EXPECT_FALSE(reported.front_bumpers(0));
  EXPECT_TRUE(reported.rear_bumpers(1));
  EXPECT_EQ(reported.charging(), robotcontrol::DriveState::NOT_CHARGING);
  EXPECT_NEAR(reported.state_of_charge(), 0.8, 1e-9);
}

TEST_F(PioneerPackagesTest, sonarReadingsSayWhereTheirSensorsAre) {
  EXPECT_EQ(packages_.sonars(informationAt(0, 0, 0), 0.001, time_), nullptr);
  StandardInformation information = informationAt(0, 0, 0);
  information.sonars = {{3, 1500}, {8, 9999}, {31, 700}};  // there is no 31
  const auto readings = packages_.sonars(information, 0.001, time_);
  ASSERT_EQ(readings->readings_size(), 2);
  EXPECT_EQ(readings->readings(0).number(), 3U);
  EXPECT_NEAR(readings->readings(0).range(), 1.5, 1e-9);
  EXPECT_NEAR(readings->readings(0).sensor_in_robot().x(), 0.245, 1e-9);
  EXPECT_NEAR(readings->readings(0).sensor_in_robot().heading(), robotlink::radians(10.0), 1e-9);
  EXPECT_EQ(readings->readings(1).range(), readings->maximum());
}

TEST_F(PioneerPackagesTest, aScanIsSeenFromWhereTheLaserIs) {
  robotlink::arcos::RangeScan seen;
  seen.time = Instant(milliseconds(5));
  seen.ranges.assign(40, 2.0);
  const auto scan = packages_.laser(seen);
  ASSERT_NE(scan, nullptr);
  EXPECT_EQ(scan->ranges_size(), 40);
  EXPECT_NEAR(scan->ranges(39), 2.0, 1e-9);
  EXPECT_NEAR(scan->start_angle(), -robotlink::kPi / 2, 1e-9);
  EXPECT_NEAR(scan->pose().position().x(), 0.125, 1e-9);
  EXPECT_EQ(robotlink::instant(scan->timestamp()), Instant(milliseconds(5)));
}

TEST(PioneerDescription, theClientLibraryKnowsTheRobotAsItIsDescribed) {
  const robotlink::arcos::RobotType type = robotlink::arcos::robotType("p3at-sh");
  const auto& described = pioneer();
  EXPECT_EQ(type.track, described.drive->track);
  EXPECT_EQ(type.length, described.drive->length);
  EXPECT_EQ(type.width, described.drive->width);
  EXPECT_EQ(type.sonarMaximum, described.sonars->maximum);
  EXPECT_NEAR(type.sonarOpeningAngle, described.sonars->openingAngle, 1e-9);
  EXPECT_EQ(type.laserInRobot, described.laser->inRobot);
  ASSERT_EQ(type.sonarsInRobot.size(), described.sonars->sensors.size());
  for (std::size_t i = 0; i < type.sonarsInRobot.size(); ++i) {
    const robotlink::Pose2 known = type.sonarsInRobot[i], there = described.sonars->sensors[i].inRobot;
    EXPECT_NEAR((known.translation() - there.translation()).norm(), 0, 1e-9) << i;
    EXPECT_NEAR(known.heading, there.heading, 1e-9) << i;
  }
}
