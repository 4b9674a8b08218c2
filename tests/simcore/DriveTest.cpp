// SPDX-License-Identifier: GPL-3.0-or-later
// How the Pioneer drives, by forces.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simcore/DriveScenes.h"

namespace simcore {
namespace {

using robotlink::degrees;
using robotlink::kPi;
using robotlink::radians;

/// The angle by which the robot turned, from its rims' travel and its change of heading, in what follows
/// `from`.
class TrackMeter {
 public:
  explicit TrackMeter(DrivenWorld& world) : world_(world), heading_(world.pose().heading), start_(turned()) {}
  double track() const {
    return (turned() - start_) / std::remainder(world_.pose().heading - heading_, 2 * kPi);
  }

 private:
  double turned() const { return world_->wheelState(0).rightTravel - world_->wheelState(0).leftTravel; }

  DrivenWorld& world_;
  double heading_, start_;
};

TEST(Drive, straightIsStraightWithinOnePercent) {
  DrivenWorld world(pioneerAt("p3at1", 0, 0));
  world.drive(0.5, 0.5, 12);
  world.drive(0, 0, 2);
  const robotlink::Pose2 end = world.pose();
  EXPECT_GT(end.x, 5);
  EXPECT_LT(std::abs(end.y), 0.01 * end.x);
  EXPECT_LT(std::abs(degrees(end.heading)), 0.5);
  EXPECT_NEAR(world->wheelState(0).leftTravel, end.x, 0.01 * end.x);
  EXPECT_NEAR(world->wheelState(0).rightTravel, end.x, 0.01 * end.x);
}

TEST(Drive, onTheSpotItTurnsAboutItsTrackHoweverFast) {
  for (const double rate : {5.0, 20.0, 50.0, 100.0}) {
    DrivenWorld world(pioneerAt("p3at1", 0, 0));
    const double speed = radians(rate) * world->drives()[0].track / 2;
    world.drive(-speed, speed, 3);
    const TrackMeter meter(world);
    world.drive(-speed, speed, 0.8);
    EXPECT_NEAR(meter.track(), 0.588, 0.588 * 0.02) << rate << " degrees/s";
    EXPECT_LT(world.pose().translation().norm(), 0.02) << rate << " degrees/s";
  }
}

TEST(Drive, inCurvesItTurnsAboutItsTrack) {
  DrivenWorld world(pioneerAt("p3at1", 0, 0));
  world.drive(0.3, 0.5, 3);
  const TrackMeter meter(world);
  world.drive(0.3, 0.5, 3);
  EXPECT_NEAR(meter.track(), 0.588, 0.588 * 0.03);
}

TEST(Drive, aStopIsAShortOne) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0));
  world.drive(0.5, 0.5, 3);
  double start = world.pose().x;
  world.drive(0, 0, 2.5);
  // From 0.5 m/s at 0.3 m/s^2.
  EXPECT_NEAR(world.pose().x - start, 0.417, 0.01);
  world.drive(0.5, 0.5, 3);
  start = world.pose().x;
  world.jerk(0, 0, 1);
  EXPECT_LT(world.pose().x - start, 0.05) << "wheels held at once";
  EXPECT_GT(world.pose().x - start, 0.01);
}

TEST(Drive, withoutPowerItRollsOutAgainstItsGears) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0));
  world.drive(0.5, 0.5, 3);
  const double start = world.pose().x, travel = world->wheelState(0).leftTravel;
  world->setDriveOn(0, false);
  world.jerk(0.5, 0.5, 2);
  EXPECT_NEAR(world.pose().x - start, 0.143, 0.03);
  EXPECT_NEAR(world->wheelState(0).leftTravel - travel, world.pose().x - start, 0.005);
  EXPECT_EQ(world->wheelState(0).leftSpeed, 0);
  EXPECT_FALSE(world->wheelState(0).leftBlocked);
  world->setDriveOn(0, true);
  world.jerk(0.2, 0.2, 1);
  EXPECT_NEAR(world->wheelState(0).leftSpeed, 0.2, 1e-9);
}

TEST(Drive, pushingAWallItStallsUntilItsNextCommand) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + wallAhead());
  world.drive(0.4, 0.4, 3);
  EXPECT_FALSE(world->wheelState(0).leftBlocked || world->wheelState(0).rightBlocked);
  EXPECT_EQ(world->obstacleContacts(kRobot), 0U);
  world.drive(0.4, 0.4, 2);
  EXPECT_TRUE(world->wheelState(0).leftBlocked && world->wheelState(0).rightBlocked);
  EXPECT_NEAR(world->wheelState(0).leftSpeed, 0, 0.01);
  EXPECT_NEAR(world.pose().x + 0.313, 1.45, 0.005);
  EXPECT_NEAR(world->wheelState(0).leftTravel, world.pose().x, 0.01) << "wheels stand, they do not spin";
  world.drive(0, 0, 2);
  EXPECT_FALSE(world->wheelState(0).leftBlocked || world->wheelState(0).rightBlocked);
  world.drive(-0.3, -0.3, 2);
  EXPECT_FALSE(world->wheelState(0).leftBlocked || world->wheelState(0).rightBlocked);
  EXPECT_LT(world.pose().x, 0.8);
  EXPECT_EQ(world->obstacleContacts(kRobot), 1U);
}

TEST(Drive, bumpersReportWhichSegmentTouches) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + wallAhead());
  world.drive(0.4, 0.4, 5);
  for (const char* segment :
       {"frontBumper1", "frontBumper2", "frontBumper4", "frontBumper5", "rearBumper3"}) {
    EXPECT_EQ(world.reading(std::string("p3at1/") + segment), 0) << segment;
  }
  EXPECT_EQ(world.reading("p3at1/frontBumper3"), 1);
  world.drive(-0.4, -0.4, 3);
  EXPECT_EQ(world.reading("p3at1/frontBumper3"), 0);
}

TEST(Drive, bumpersAreNumberedFromLeftToRightSeenFromAbove) {
  const struct {
    double heading;
    const char* bumper;
    double speed;
  } cases[] = {{-0.9, "frontBumper1", 0.3},
               {0.9, "frontBumper5", 0.3},
               {robotlink::kPi - 0.9, "rearBumper5", -0.3},
               {robotlink::kPi + 0.9, "rearBumper1", -0.3}};
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + wallAhead());
  for (const auto& one : cases) {
    // The corner towards the wall is the nearest to it.
    ASSERT_TRUE(world->placeModel(kRobot, {0.85, 0, one.heading}));
    bool touched = false;
    for (int i = 0; i < 200 && !touched; ++i) {
      world.jerk(one.speed, one.speed, 0.02);
      touched = world.reading(std::string("p3at1/") + one.bumper) == 1;
    }
    EXPECT_TRUE(touched) << one.bumper;
  }
}

TEST(Drive, theGyroscopeMeasuresHowFastItTurns) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0));
  world.drive(-0.147, 0.147, 2);
  EXPECT_NEAR(world.reading("p3at1/gyroscope", 2), 0.5, 0.02);
  EXPECT_NEAR(world.reading("p3at1/gyroscope", 0), 0, 0.02);
  world.drive(0, 0, 2);
  EXPECT_NEAR(world.reading("p3at1/gyroscope", 2), 0, 0.005);
  DrivenWorld noisy(pioneerAt(kRobot, 0, 0), {.seed = 1, .noise = true});
  double squares = 0;
  for (int i = 0; i < 500; ++i) {
    noisy->step();
    squares += std::pow(noisy.reading("p3at1/gyroscope", 1), 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 500), 0.005, 0.001);
}

TEST(Drive, aRobotWithoutPowerCanBePushedByAnother) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + pioneerAt("p3at2", 1.2, 0));
  world->setDriveOn(1, false);
  world.drive(0.4, 0.4, 6);
  EXPECT_GT(world.pose("p3at2").x, 2.5);
  EXPECT_NEAR(world->wheelState(1).leftTravel, world.pose("p3at2").x - 1.2, 0.01) << "its encoders see that";
  EXPECT_EQ(world->obstacleContacts(kRobot), 1U);
  EXPECT_EQ(world->obstacleContacts("p3at2"), 1U);
  EXPECT_GT(robotlink::seconds(world->obstacleContactTime("p3at2")), 3);
}

TEST(Drive, itDrivesUpARampAndStandsOnIt) {
  // 30 %: the tires hold, and so do the motors.
  const double slope = std::atan(0.3);
  const robotlink::Vector3 middle(3.5 - 0.05 * std::sin(slope), 0, 0.6 - 0.05 * std::cos(slope));
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + boxAt("ramp", middle, {4.3, 3, 0.1}, -slope));
  world.drive(0.4, 0.4, 8);
  world.drive(0, 0, 2);
  const Pose3 stopped = *world->modelPose(kRobot);
  EXPECT_GT(stopped.translation().z(), 0.3);
  EXPECT_NEAR(std::asin(stopped.linear()(2, 0)), slope, 0.02);
  world.drive(0, 0, 3);
  EXPECT_LT((world->modelPose(kRobot)->translation() - stopped.translation()).norm(), 0.003);
  world->setDriveOn(0, false);
  world.drive(0, 0, 3);
  EXPECT_LT(world->modelPose(kRobot)->translation().z(), stopped.translation().z() - 0.1)
      << "idle, it rolls down";
}

TEST(Drive, itClimbsASillAndStallsAtOneThatIsTooHigh) {
  const auto sillAt = [](double y, double height) {
    return boxAt("sill" + std::to_string(static_cast<int>(y)), {1, y, height / 2}, {0.1, 1, height});
  };
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + sillAt(0, 0.02) + sillAt(2, 0.05) + sillAt(4, 0.12));
  for (const double lane : {0.0, 2.0}) {
    ASSERT_TRUE(world->placeModel(kRobot, {0, lane, 0}));
    world.drive(0.4, 0.4, 6);
    EXPECT_GT(world.pose().x, 1.9) << lane;
    EXPECT_NEAR(degrees(world.pose().heading), 0, 1) << lane;
    world.jerk(0, 0, 0.2);
  }
  ASSERT_TRUE(world->placeModel(kRobot, {0, 4, 0}));
  world.drive(0.4, 0.4, 6);
  EXPECT_LT(world.pose().x, 1);
  EXPECT_TRUE(world->wheelState(0).leftBlocked);
}

TEST(Drive, itStandsStillForAMinute) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0));
  world.drive(0, 0, 60);
  EXPECT_LT(world.pose().translation().norm(), 0.001);
  EXPECT_LT(std::abs(degrees(world.pose().heading)), 0.1);
}

TEST(Drive, requestsAreLimitedAndMustBeNumbers) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0));
  world.jerk(100, -100, 0.2);
  EXPECT_NEAR(world->wheelState(0).leftSpeed, world->drives()[0].maximumSpeed, 0.2);
  EXPECT_LE(world->wheelState(0).leftSpeed, world->drives()[0].maximumSpeed);
  world->requestWheelSpeeds(0, std::nan(""), 0);
  world->step();
  EXPECT_GT(world->wheelState(0).leftSpeed, 0.5);
}

TEST(Drive, aRobotMayStandCloseBesideAWall) {
  // Its wheels are spheres to the solver, but only as wide as they are.
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + boxAt("wall", {0, 0.32, 0.5}, {9, 0.1, 1}));
  world.drive(0.3, 0.3, 4);
  EXPECT_EQ(world->obstacleContacts(kRobot), 0U);
  EXPECT_NEAR(world.pose().y, 0, 0.005);
  EXPECT_TRUE(world->placeModel(kRobot, {-1, 0.005, 0}));
  const auto refused = world->placeModel(kRobot, {-1, 0.05, 0});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text.find("'wall' is in the way"), std::string::npos);
}

TEST(Drive, theSameSeedGivesTheSameBytes) {
  const auto digest = [](std::uint64_t seed) {
    DrivenWorld world(pioneerAt(kRobot, 0, 0) + pioneerAt("p3at2", 1, 0.2, 3) + wallAhead(),
                      {.seed = seed, .noise = true});
    world->requestWheelSpeeds(1, 0.3, 0.2);
    world.drive(0.4, 0.3, 4);
    return world->digest();
  };
  EXPECT_EQ(digest(1), digest(1));
  EXPECT_NE(digest(1), digest(2));
}

}  // namespace
}  // namespace simcore
