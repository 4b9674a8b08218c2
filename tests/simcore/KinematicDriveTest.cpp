// SPDX-License-Identifier: GPL-3.0-or-later
// How the Pioneer is moved by its odometry alone.
#include <gtest/gtest.h>

#include "tests/simcore/DriveScenes.h"

namespace simcore {
namespace {

const SimulationOptions kKinematic{.seed = 1, .noise = false, .kinematic = true};

TEST(KinematicDrive, itGoesExactlyAsItsWheelsSay) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0), kKinematic);
  world.jerk(0.3, 0.3, 2);
  EXPECT_NEAR(world.pose().x, 0.6, 1e-9);
  EXPECT_NEAR(world->wheelState(0).leftTravel, 0.6, 1e-9);
  world.jerk(-0.1, 0.1, 1);
  EXPECT_NEAR(world.pose().heading, 0.2 / 0.588, 1e-6);
  EXPECT_NEAR(world.reading("p3at1/gyroscope", 2), 0.2 / 0.588, 1e-9);
  // A quarter of a circle of 1 m.
  ASSERT_TRUE(world->placeModel(kRobot, {0, 0, 0}));
  const double rate = robotlink::kPi / 8;
  world.jerk(rate * (1 - 0.294), rate * (1 + 0.294), 4);
  EXPECT_NEAR(world.pose().x, 1, 1e-4);
  EXPECT_NEAR(world.pose().y, 1, 1e-4);
}

TEST(KinematicDrive, itStopsAtAWallAndIsBlockedUntilItTurnsAway) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + wallAhead(), kKinematic);
  world.jerk(0.4, 0.4, 2.5);
  EXPECT_FALSE(world->wheelState(0).leftBlocked);
  EXPECT_EQ(world->obstacleContacts(kRobot), 0U);
  world.jerk(0.4, 0.4, 2);
  EXPECT_NEAR(world.pose().x, 1.45 - 0.313, 0.001);
  EXPECT_TRUE(world->wheelState(0).leftBlocked && world->wheelState(0).rightBlocked);
  EXPECT_EQ(world->wheelState(0).leftSpeed, 0);
  EXPECT_NEAR(world->wheelState(0).leftTravel, world.pose().x, 0.004);
  EXPECT_EQ(world.reading("p3at1/frontBumper3"), 1);
  EXPECT_EQ(world.reading("p3at1/frontBumper1"), 0);
  EXPECT_EQ(world->obstacleContacts(kRobot), 1U);
  world.jerk(0, 0, 1);
  EXPECT_FALSE(world->wheelState(0).leftBlocked);
  EXPECT_EQ(world.reading("p3at1/frontBumper3"), 1) << "it still leans on it";
  world.jerk(-0.3, -0.3, 1);
  EXPECT_EQ(world.reading("p3at1/frontBumper3"), 0);
  EXPECT_NEAR(world.pose().x, 1.45 - 0.313 - 0.3, 0.002);
  EXPECT_EQ(world->obstacleContacts(kRobot), 1U);
}

TEST(KinematicDrive, aWallInManyPiecesStopsItToo) {
  // So many that they are found by the grid.
  const std::string pieces = piecesAt(1.5, -2, 2, 80);
  for (const bool kinematic : {true, false}) {
    DrivenWorld world(pioneerAt(kRobot, 0, 0) + pieces, {.seed = 1, .noise = false, .kinematic = kinematic});
    world.drive(0.4, 0.4, 5);
    EXPECT_NEAR(world.pose().x, 1.45 - 0.313, 0.005);
    EXPECT_TRUE(world->wheelState(0).leftBlocked);
  }
}

TEST(KinematicDrive, robotsDoNotDriveThroughEachOther) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + pioneerAt("p3at2", 2, 0, robotlink::kPi), kKinematic);
  world->requestWheelSpeeds(1, 0.3, 0.3);
  world.jerk(0.3, 0.3, 6);
  EXPECT_NEAR(world.pose("p3at2").x - world.pose().x, 0.626, 0.005);
  EXPECT_TRUE(world->wheelState(0).leftBlocked);
  EXPECT_TRUE(world->wheelState(1).leftBlocked);
  EXPECT_EQ(world->obstacleContacts(kRobot), 1U);
  EXPECT_EQ(world->obstacleContacts("p3at2"), 1U);
}

TEST(KinematicDrive, whatIsLooseStopsItAndBouncesOffIt) {
  const std::string crate =
      "<model name=\"crate\"><pose>1.2 0 0.6 0 0 0</pose><link "
      "name=\"crate\"><inertial><mass>2</mass><inertia><ixx>0.03"
      "</ixx><iyy>0.03</iyy><izz>0.03</izz></inertia></inertial><collision "
      "name=\"crate\"><geometry><box><size>0.4 0.4 0.4"
      "</size></box></geometry></collision></link></model>";
  DrivenWorld world(pioneerAt(kRobot, 0, 0) + crate, kKinematic);
  world.jerk(0.4, 0.4, 4);
  EXPECT_NEAR(world->modelPose("crate")->translation().z(), 0.2, 0.01) << "it fell to the floor";
  EXPECT_NEAR(world.pose().x, 1 - 0.313, 0.02);
  EXPECT_TRUE(world->wheelState(0).leftBlocked);
  ASSERT_TRUE(world->placeModel(kRobot, {-2, 0, 0}));
  // Thrown onto the robot, it does not fall through it.
  ASSERT_TRUE(world->placeModel("crate", {2, 0, 0}));
  world.jerk(0, 0, 0.1);
  EXPECT_NEAR(world.pose().x, -2, 1e-9);
}

TEST(KinematicDrive, withoutPowerItStandsAtOnce) {
  DrivenWorld world(pioneerAt(kRobot, 0, 0), kKinematic);
  world.jerk(0.3, 0.3, 1);
  world->setDriveOn(0, false);
  world.jerk(0.3, 0.3, 1);
  EXPECT_NEAR(world.pose().x, 0.3, 1e-9);
  EXPECT_EQ(world->wheelState(0).leftSpeed, 0);
}

TEST(KinematicDrive, theSameSeedGivesTheSameBytes) {
  const auto digest = [] {
    DrivenWorld world(pioneerAt(kRobot, 0, 0) + pioneerAt("p3at2", 1, 0.2, 3) + wallAhead(),
                      {.seed = 1, .noise = true, .kinematic = true});
    world->requestWheelSpeeds(1, 0.3, 0.2);
    world.drive(0.4, 0.3, 4);
    return world->digest();
  };
  EXPECT_EQ(digest(), digest());
}

}  // namespace
}  // namespace simcore
