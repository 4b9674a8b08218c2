// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of self-localisation and path planning of robots on wheels, by their packages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "NavigationParameters.pb.h"
#include "RollingPackages.h"
#include "foxglove/Geometry.pb.h"
#include "modules/navigation/RangePackages.h"
#include "robotcontrol/Modeling.pb.h"
#include "tests/modules/ParametersOf.h"

namespace modules {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;
using testing::IsEmpty;

std::shared_ptr<const GroundMap> crookedRoom() {
  GroundMap map = roomMap(6, 4);
  addWall(map, 2, 4, 2, 3);
  addWall(map, 4.5, 0, 4.5, 0.7);
  addWall(map, 4.5, 0.7, 6, 0.7);
  GroundMap::Place home;
  home.kind = GroundMap::Place::Kind::kHome;
  home.pose = {3, 1.5, 0};
  map.places.push_back(home);
  return std::make_shared<GroundMap>(map);
}

/// Drives circles from the home of the room for some seconds.
void circle(OneSolution& locator, RollingRobot& robot, double seconds, bool laser) {
  for (const double end = robot.time() + seconds; robot.time() < end - 1e-6;) {
    robot.drive({0.3, 0.5});
    sense(locator, robot, laser);
    locator.pass();
    locator.execute();
  }
}

class MonteCarloTest : public testing::TestWithParam<bool> {};

TEST_P(MonteCarloTest, itFindsTheRobotByWhatThePlatformSends) {
  const bool laser = GetParam();
  const auto map = crookedRoom();
  const FlatWorld world(*map);
  RollingRobot robot(world, {.start = {3, 1.5, 0}, .laser = laser});
  OneSolution locator("self-localisation", "monte-carlo", {map});
  locator.execute();
  EXPECT_EQ(nullptr, locator.sent(robotlink::kRobotPose)) << "nothing has come yet";
  circle(locator, robot, 0.1, laser);
  EXPECT_GT(locator.sent(robotlink::kRobotPose)->position_deviation(), 0.8);
  circle(locator, robot, laser ? 8 : 25, laser);
  const auto& pose = *locator.sent(robotlink::kRobotPose);
  EXPECT_LT((robotlink::pose2(pose.robot_in_field()).translation() - robot.pose().translation()).norm(), 0.2);
  EXPECT_LT(pose.position_deviation(), 0.3);
  EXPECT_EQ(robot.now(), robotlink::instant(pose.timestamp()));
  EXPECT_THAT(locator.silentKeys(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Sensors, MonteCarloTest, testing::Bool(),
                         [](const auto& laser) { return laser.param ? "laser" : "sonars"; });

TEST(MonteCarloSolution, withoutAMapItSaysSoOnceAndStaysUncertain) {
  const auto map = crookedRoom();
  const FlatWorld world(*map);
  RollingRobot robot(world, {.start = {3, 1.5, 0}});
  OneSolution locator("self-localisation", "monte-carlo");
  circle(locator, robot, 2, true);
  EXPECT_GT(locator.sent(robotlink::kRobotPose)->position_deviation(), 100);
  ASSERT_EQ(1U, locator.texts().size());
  EXPECT_EQ(1, locator.texts().begin()->second);
  EXPECT_TRUE(locator.said("there is no map"));
}

TEST(MonteCarloSolution, aMapWithoutRoomIsToldOnce) {
  auto tiny = std::make_shared<GroundMap>(roomMap(0.2, 0.2));
  OneSolution locator("self-localisation", "monte-carlo", {tiny});
  locator.execute();
  EXPECT_TRUE(locator.said("no place where the robot fits"));
}

TEST(MonteCarloSolution, messagesThatAreNoNumbersDoNoHarm) {
  const auto map = crookedRoom();
  const FlatWorld world(*map);
  RollingRobot robot(world, {.start = {3, 1.5, 0}});
  OneSolution locator("self-localisation", "monte-carlo", {map});
  circle(locator, robot, 8, true);
  robotcontrol::DriveState bad = driveState(robot);
  bad.mutable_odometry()->set_x(std::nan(""));
  foxglove::LaserScan scan;
  *scan.mutable_timestamp() = bad.timestamp();
  for (int i = 0; i < 10; ++i) scan.add_ranges(i % 2 == 0 ? std::nan("") : -1);
  scan.set_start_angle(std::nan(""));
  locator.set(robotlink::kDriveState, bad);
  locator.set(robotlink::kLaser, scan);
  locator.execute();
  circle(locator, robot, 1, true);
  const Pose2 pose = robotlink::pose2(locator.sent(robotlink::kRobotPose)->robot_in_field());
  EXPECT_LT((pose.translation() - robot.pose().translation()).norm(), 0.2);
}

TEST(MonteCarloSolution, anOdometryThatIsSetToZeroMovesNobody) {
  const auto map = crookedRoom();
  const FlatWorld world(*map);
  RollingRobot robot(world, {.start = {3, 1.5, 0}});
  OneSolution locator("self-localisation", "monte-carlo", {map});
  circle(locator, robot, 8, true);
  const Pose2 before = robotlink::pose2(locator.sent(robotlink::kRobotPose)->robot_in_field());
  robotcontrol::DriveState reset = driveState(robot);
  robotlink::assign(*reset.mutable_odometry(), Pose2{-40, 12, 2});
  locator.set(robotlink::kDriveState, reset);
  locator.pass();
  locator.execute();
  const Pose2 after = robotlink::pose2(locator.sent(robotlink::kRobotPose)->robot_in_field());
  EXPECT_LT((after.translation() - before.translation()).norm(), 0.1);
}

TEST(MonteCarloSolution, itMayBeginAtHome) {
  OneSolution locator(
      "self-localisation", "monte-carlo", {crookedRoom()}, [](google::protobuf::Message& parameters) {
        static_cast<robotcontrol::MonteCarloLocalisationParameters&>(parameters).set_start_at_home(true);
      });
  locator.set(robotlink::kDriveState, robotcontrol::DriveState());
  locator.execute();
  const auto& pose = *locator.sent(robotlink::kRobotPose);
  EXPECT_NEAR(3, pose.robot_in_field().x(), 0.2);
  EXPECT_NEAR(1.5, pose.robot_in_field().y(), 0.2);
  EXPECT_LT(pose.position_deviation(), 0.7);
}

TEST(WheelOdometry, reckonsFromTheHomeOfTheMapAndGrowsUnsure) {
  const auto map = crookedRoom();
  const FlatWorld world(*map);
  RollingRobot robot(world, {.start = {3, 1.5, 0}, .skid = 0});
  OneSolution locator("self-localisation", "wheel-odometry", {map});
  double last = -1;
  for (int i = 0; i < 30; ++i) {
    robot.drive({0.3, 0.5});
    locator.set(robotlink::kDriveState, driveState(robot));
    locator.pass();
    locator.execute();
    EXPECT_GT(locator.sent(robotlink::kRobotPose)->position_deviation(), last);
    last = locator.sent(robotlink::kRobotPose)->position_deviation();
  }
  const Pose2 pose = robotlink::pose2(locator.sent(robotlink::kRobotPose)->robot_in_field());
  EXPECT_LT((pose.translation() - robot.pose().translation()).norm(), 1e-6);
  EXPECT_THAT(locator.silentKeys(), IsEmpty());
}

robotcontrol::RobotPose poseAt(double x, double y, double deviation = 0.1) {
  robotcontrol::RobotPose pose;
  robotlink::assign(*pose.mutable_robot_in_field(), Pose2{x, y, 0});
  pose.set_position_deviation(deviation);
  return pose;
}

robotcontrol::DriveGoal goalAt(double x, double y, const char* name = "") {
  robotcontrol::DriveGoal goal;
  robotlink::assign(*goal.mutable_pose_in_field(), Pose2{x, y, 1});
  goal.set_name(name);
  return goal;
}

TEST(GridPathPlanning, plansToTheGoalAndSaysHowFarItIs) {
  OneSolution planner("path-planning", "grid", {crookedRoom()});
  planner.set(robotlink::kRobotPose, poseAt(1, 3.3));
  planner.execute();
  ASSERT_NE(nullptr, planner.sent(robotlink::kDrivePath));
  EXPECT_FALSE(planner.sent(robotlink::kDrivePath)->has_goal());
  planner.set(robotlink::kDriveGoal, goalAt(3, 3.3, "Desk"));
  planner.pass(0.01);
  planner.execute();
  const auto& path = *planner.sent(robotlink::kDrivePath);
  EXPECT_FALSE(path.blocked());
  ASSERT_GE(path.points_in_field_size(), 3);
  EXPECT_EQ(Vector2(1, 3.3), robotlink::vector2(path.points_in_field(0)));
  EXPECT_EQ(Vector2(3, 3.3), robotlink::vector2(path.points_in_field(path.points_in_field_size() - 1)));
  EXPECT_EQ("Desk", path.goal().name());
  EXPECT_TRUE(planner.said("to “Desk” it is "));
  EXPECT_THAT(planner.silentKeys(), IsEmpty());
}

TEST(GridPathPlanning, saysOnceWhyThereIsNoWay) {
  OneSolution planner("path-planning", "grid", {crookedRoom()});
  planner.set(robotlink::kRobotPose, poseAt(1, 3.3));
  planner.set(robotlink::kDriveGoal, goalAt(2, 3.5));
  for (int i = 0; i < 30; ++i) {
    planner.execute();
    planner.pass();
  }
  EXPECT_TRUE(planner.sent(robotlink::kDrivePath)->blocked());
  EXPECT_EQ("the goal is too near to a wall for this robot", planner.sent(robotlink::kDrivePath)->reason());
  ASSERT_EQ(1U, planner.texts().size());
  EXPECT_EQ(1, planner.texts().begin()->second);
}

TEST(GridPathPlanning, aCanceledGoalIsNone) {
  OneSolution planner("path-planning", "grid", {crookedRoom()});
  planner.set(robotlink::kRobotPose, poseAt(1, 3.3));
  robotcontrol::DriveGoal goal = goalAt(3, 3.3);
  goal.set_cancelled(true);
  planner.set(robotlink::kDriveGoal, goal);
  planner.execute();
  EXPECT_FALSE(planner.sent(robotlink::kDrivePath)->has_goal());
}

/// A robot that drives to a goal by the planned path, as the path follower does; `map` is what its program
/// knows of the world.
class PlannedDrive {
 public:
  PlannedDrive(const GroundMap& map, const GroundMap& world)
      : world_(world),
        robot_(world_, {.start = {1.5, 2, 0}, .skid = 0}),
        planner_("path-planning", "grid", {.map = std::make_shared<GroundMap>(map), .keys = false}) {
    planner_.set(robotlink::kDriveGoal, goalAt(6.5, 2, "Desk"));
  }
  void run(double seconds) {
    for (const double end = robot_.time() + seconds; robot_.time() < end;) {
      robotcontrol::RobotPose pose = poseAt(0, 0, 0.05);
      robotlink::assign(*pose.mutable_timestamp(), robot_.now());
      robotlink::assign(*pose.mutable_robot_in_field(), robot_.pose());
      planner_.set(robotlink::kRobotPose, pose);
      planner_.set(robotlink::kDriveState, driveState(robot_));
      planner_.set(robotlink::kLaser, laserScan(robot_));
      planner_.pass();
      planner_.execute();
      follow(path());
    }
  }
  const robotcontrol::DrivePath& path() const { return *planner_.sent(robotlink::kDrivePath); }
  const RollingRobot& robot() const { return robot_; }
  OneSolution& planner() { return planner_; }

 private:
  void follow(const robotcontrol::DrivePath& path) {
    for (const auto& point : path.points_in_field()) {
      const Vector2 toPoint = robot_.pose().inverse() * robotlink::vector2(point);
      if (toPoint.norm() < 0.2) continue;
      const double direction = std::atan2(toPoint.y(), toPoint.x());
      const double speed = std::abs(direction) < 0.3 ? std::min(0.4, toPoint.norm()) : 0;
      return robot_.drive({speed, std::clamp(1.5 * direction, -0.8, 0.8)});
    }
    robot_.drive({});
  }

  FlatWorld world_;
  RollingRobot robot_;
  OneSolution planner_;
};

/// Two rooms of 4 m by 8 m with a door, or two, between them.
GroundMap roomsWithDoors(bool second) {
  GroundMap map = roomMap(8, 8);
  addWall(map, 4, 0, 4, 1.5);
  addWall(map, 4, 2.5, 4, second ? 5.5 : 8);
  if (second) addWall(map, 4, 6.5, 4, 8);
  return map;
}

GroundMap withBoxInTheDoor(GroundMap map) {
  addWall(map, 3.8, 1.75, 3.8, 2.25);
  addWall(map, 3.8, 2.25, 4.2, 2.25);
  addWall(map, 4.2, 2.25, 4.2, 1.75);
  addWall(map, 4.2, 1.75, 3.8, 1.75);
  return map;
}

TEST(GridPathPlanning, aDoorThatIsBlockedIsAvoidedThroughAnotherOne) {
  const GroundMap map = roomsWithDoors(true);
  PlannedDrive drive(map, withBoxInTheDoor(map));
  drive.run(90);
  EXPECT_LT((drive.robot().pose().translation() - Vector2(6.5, 2)).norm(), 0.3);
  EXPECT_GT(drive.robot().nearest(), 0) << "it touched something";
  EXPECT_TRUE(drive.planner().said("around something that is not on the map"));
  PlannedDrive open(map, map);
  open.run(40);
  EXPECT_LT((open.robot().pose().translation() - Vector2(6.5, 2)).norm(), 0.3);
  EXPECT_FALSE(open.planner().said("not on the map"));
}

TEST(GridPathPlanning, itGivesUpWithAReasonWhereTheOnlyDoorIsBlocked) {
  const GroundMap map = roomsWithDoors(false);
  PlannedDrive drive(map, withBoxInTheDoor(map));
  drive.run(30);
  EXPECT_TRUE(drive.path().blocked());
  EXPECT_EQ("an obstacle that is not on the map blocks every path to the goal", drive.path().reason());
  EXPECT_GT(drive.robot().nearest(), 0);
  EXPECT_TRUE(drive.planner().said("no way to “Desk”: an obstacle that is not on the map blocks"));
}

TEST(GridPathPlanning, whereThePoseIsUnsureNothingCountsAsAnObstacle) {
  const GroundMap map = roomsWithDoors(true);
  OneSolution planner("path-planning", "grid", {std::make_shared<GroundMap>(map)});
  planner.set(robotlink::kDriveGoal, goalAt(6.5, 2));
  const FlatWorld world(withBoxInTheDoor(map));
  RollingRobot robot(world, {.start = {2, 2, 0}});
  for (int i = 0; i < 20; ++i) {
    planner.set(robotlink::kRobotPose, poseAt(2, 2, 0.5));
    planner.set(robotlink::kDriveState, driveState(robot));
    planner.set(robotlink::kLaser, laserScan(robot));
    planner.pass();
    planner.execute();
  }
  EXPECT_FALSE(planner.said("not on the map"));
}

TEST(GridPathPlanning, whoDoesNotKnowWhereItIsHasNoWayYet) {
  OneSolution planner("path-planning", "grid", {crookedRoom()});
  planner.set(robotlink::kRobotPose, poseAt(1, 3.3, 3));
  planner.set(robotlink::kDriveGoal, goalAt(3, 3.3));
  planner.execute();
  EXPECT_EQ(0, planner.sent(robotlink::kDrivePath)->points_in_field_size());
  EXPECT_FALSE(planner.sent(robotlink::kDrivePath)->reason().empty());
  planner.set(robotlink::kRobotPose, poseAt(1, 3.3));
  planner.pass(1);
  planner.execute();
  EXPECT_GT(planner.sent(robotlink::kDrivePath)->points_in_field_size(), 1);
}

TEST(GridPathPlanning, withoutAMapItSaysSo) {
  OneSolution planner("path-planning", "grid");
  planner.set(robotlink::kRobotPose, poseAt(1, 3.3));
  planner.set(robotlink::kDriveGoal, goalAt(3, 3.3));
  planner.execute();
  EXPECT_TRUE(planner.said("there is no map to plan in: open one"));
  EXPECT_TRUE(planner.sent(robotlink::kDrivePath)->blocked());
}

TEST(DirectPathPlanning, goesStraightThroughEverything) {
  OneSolution planner("path-planning", "direct");
  planner.set(robotlink::kRobotPose, poseAt(1, 3.3));
  planner.set(robotlink::kDriveGoal, goalAt(3, 3.3));
  planner.execute();
  EXPECT_EQ(2, planner.sent(robotlink::kDrivePath)->points_in_field_size());
  EXPECT_THAT(planner.silentKeys(), IsEmpty());
}

TEST(RangePackages, readingsKeepTheirTimesAndPlaces) {
  const FlatWorld world(roomMap(4, 4));
  const RollingRobot robot(world, {.start = {2, 2, 0}});
  const auto cones = beams(sonarReadings(robot));
  const auto rays = beams(laserScan(robot), robot.description().laser->maximum);
  ASSERT_EQ(2U, cones.size());
  ASSERT_EQ(181U, rays.size());
  EXPECT_NEAR(robotlink::radians(30), cones[0].openingAngle, 1e-9);
  EXPECT_NEAR(2, rays[90].endInRobot().x(), 0.03);
  EXPECT_NEAR(0, rays[90].endInRobot().y(), 0.03);
  EXPECT_NEAR(-2, rays[0].endInRobot().y(), 0.03);
}

TEST(RangePackages, whatIsNoDistanceIsLeftOut) {
  robotcontrol::SonarReadings sonar;
  sonar.set_maximum(5);
  sonar.add_readings()->set_range(0);
  sonar.add_readings()->set_range(-1);
  sonar.add_readings()->set_range(std::nan(""));
  sonar.add_readings()->set_range(7);
  ASSERT_EQ(1U, beams(sonar).size());
  EXPECT_FALSE(beams(sonar)[0].hit());
  foxglove::LaserScan scan;
  for (int i = 0; i < 100'000; ++i) scan.add_ranges(1);
  EXPECT_LE(beams(scan, 32).size(), 4096U);
}

TEST(NavigationParameters, withoutAFileAViewIsToldTheBuiltInValuesOfTheRobot) {
  const ParametersOf<robotcontrol::MonteCarloLocalisationParameters> filter("self-localisation",
                                                                            "monte-carlo");
  EXPECT_EQ("", namesOfUnset(filter.defaults()));
  EXPECT_EQ(40, filter.defaults().rays());
  EXPECT_EQ(1, filter.defaults().sonar_after());
  EXPECT_EQ("", namesOfUnset(
                    ParametersOf<robotcontrol::WheelOdometryParameters>("self-localisation", "wheel-odometry")
                        .defaults()));
  robotlink::RobotSetup robot;
  robot.description.drive = robotlink::RobotDescription::Drive();
  robot.description.drive->width = 0.2;
  const ParametersOf<robotcontrol::GridPlanningParameters> grid("path-planning", "grid", "", robot);
  EXPECT_EQ("", namesOfUnset(grid.defaults()));
  EXPECT_NEAR(0.17, grid.defaults().clearance(), 1e-9);
}

TEST(NavigationParameters, zeroIsUsedOrRefusedWithAReason) {
  ParametersOf<robotcontrol::MonteCarloLocalisationParameters> filter("self-localisation", "monte-carlo");
  robotcontrol::MonteCarloLocalisationParameters values = filter.values();
  values.set_way_noise(0);
  EXPECT_EQ("", filter.set(values));
  EXPECT_TRUE(filter.values().has_way_noise());
  EXPECT_EQ(0, filter.values().way_noise());
  values.set_random_share(0);
  EXPECT_EQ("'random_share' has to be more than 0 and at most 1", filter.set(values));
  values = filter.values();
  values.set_rays(0);
  EXPECT_EQ("'rays' has to be at least 1", filter.set(values));
}

TEST(NavigationParameters, anOdometryWithoutDriftStaysCertain) {
  const auto map = crookedRoom();
  const FlatWorld world(*map);
  RollingRobot robot(world, {.start = {3, 1.5, 0}});
  OneSolution locator("self-localisation", "wheel-odometry", {map},
                      [](google::protobuf::Message& parameters) {
                        auto& drift = static_cast<robotcontrol::WheelOdometryParameters&>(parameters);
                        drift.set_drift_per_metre(0);
                        drift.set_drift_per_radian(0);
                      });
  for (int i = 0; i < 30; ++i) {
    robot.drive({0.3, 0.5});
    locator.set(robotlink::kDriveState, driveState(robot));
    locator.pass();
    locator.execute();
  }
  ASSERT_NE(nullptr, locator.sent(robotlink::kRobotPose));
  EXPECT_EQ(0, locator.sent(robotlink::kRobotPose)->position_deviation());
  EXPECT_EQ(0, locator.sent(robotlink::kRobotPose)->heading_deviation());
}

}  // namespace
}  // namespace modules
