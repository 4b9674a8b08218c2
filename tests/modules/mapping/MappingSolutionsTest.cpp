// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "mapping", by their packages: what they make of a building that a robot drives
// through.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "MappingParameters.pb.h"
#include "foxglove/Grid.pb.h"
#include "modules/navigation/GridPlanner.h"
#include "modules/navigation/MonteCarloLocalizer.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/packages/GridConversions.h"
#include "robotlink/packages/MapPackages.h"
#include "tests/TestFolder.h"
#include "tests/modules/OneSolution.h"
#include "tests/modules/ParametersOf.h"
#include "tests/modules/driving/RollingPackages.h"
#include "tests/modules/mapping/Building.h"

namespace modules {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;
using testing::IsEmpty;

constexpr Pose2 kStart{2, 4.5, 0};

/// A robot that drives a tour of the building, and the solution that makes a map of it meanwhile.
class MappedBuilding {
 public:
  /// `skid`: as of RollingRobot.
  MappedBuilding(const std::string& solution, double skid, std::uint64_t seed = 1)
      : truth_(std::make_shared<GroundMap>(withHome())),
        world_(*truth_),
        robot_(world_, {.start = kStart, .skid = skid, .seed = seed}),
        mapper_("mapping", solution, {.map = truth_, .keys = false}) {}

  void drive(std::span<const Vector2> points) {
    driveAlong(robot_, points, [this] { sense(); });
  }
  /// The robot's pose in the map according to the solution, and how far that is from the truth.
  double error() const {
    const auto* pose = mapper_.sent(robotlink::kRobotPose);
    return (robotlink::pose2(pose->robot_in_field()).translation() - robot_.pose().translation()).norm();
  }
  const foxglove::Grid& grid() const { return *mapper_.sent(robotlink::kGridMap); }
  MapAgreement agreement() const {
    return modules::agreement(*truth_, robotlink::groundMap(grid()).value().points);
  }
  OneSolution& mapper() { return mapper_; }
  RollingRobot& robot() { return robot_; }
  const FlatWorld& world() const { return world_; }
  void sense() {
    mapper_.set(robotlink::kDriveState, driveState(robot_));
    mapper_.set(robotlink::kLaser, laserScan(robot_));
    mapper_.pass();
    mapper_.execute();
  }

 private:
  static GroundMap withHome() {
    GroundMap map = buildingMap();
    GroundMap::Place home;
    home.kind = GroundMap::Place::Kind::kHome;
    home.pose = kStart;
    map.places.push_back(home);
    return map;
  }

  std::shared_ptr<const GroundMap> truth_;
  FlatWorld world_;
  RollingRobot robot_;
  OneSolution mapper_;
};

TEST(Mapping, withoutSlipDeadReckoningMakesTheTrueMap) {
  MappedBuilding building("odometry", 0);
  building.drive(buildingTour());
  EXPECT_GT(building.agreement().right, 0.95);
  EXPECT_GT(building.agreement().complete, 0.9);
}

class SlippingTest : public testing::TestWithParam<int> {};

TEST_P(SlippingTest, scanMatchingMakesABetterMapThanDeadReckoning) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  MappedBuilding reckoned("odometry", 0.05, seed), matched("scan-matching", 0.05, seed);
  reckoned.drive(buildingTour());
  matched.drive(buildingTour());
  const MapAgreement byWheels = reckoned.agreement(), byScans = matched.agreement();
  RecordProperty("right_odometry", std::to_string(byWheels.right));
  RecordProperty("right_scan_matching", std::to_string(byScans.right));
  EXPECT_GT(byScans.right, 0.9);
  EXPECT_GT(byScans.complete, 0.9);
  EXPECT_GT(byScans.right, byWheels.right + 0.2);
  EXPECT_LT(matched.error(), 0.1);
  EXPECT_LT(matched.error(), reckoned.error());
}

INSTANTIATE_TEST_SUITE_P(Seeds, SlippingTest, testing::Values(1, 2, 3));

TEST(Mapping, theSavedMapServesLocalizationAndPlanning) {
  MappedBuilding building("scan-matching", 0.03);
  building.drive(buildingTour());
  const TestFolder folder;
  auto made = robotlink::groundMap(building.grid());
  ASSERT_TRUE(made.has_value());
  ASSERT_TRUE(made->save(folder.path() / "made.map"));
  const auto map = GroundMap::load(folder.path() / "made.map");
  ASSERT_TRUE(map.has_value()) << robotlink::describe(map.error());
  EXPECT_THAT(map->notes, IsEmpty());
  EXPECT_EQ(made->points.size(), map->points.size());

  // Into the room at the other end, through two doors.
  GridPlanner planner(*map, {});
  planner.setGoal({12, 1.5});
  const PlannedPath path = planner.path({2, 7.5});
  EXPECT_EQ("", path.reason);
  EXPECT_NEAR(14.5, path.length(), 2);
  planner.setGoal({7, 2});
  EXPECT_TRUE(planner.path({2, 7.5}).blocked()) << "there is a wall";

  // A robot that is put somewhere finds itself in it.
  MonteCarloLocalizer localizer(*map, {});
  localizer.startAnywhere();
  RollingRobot robot(building.world(), {.start = {3.5, 1.5, 1}, .seed = 7});
  Pose2 last = robot.odometry();
  driveAlong(robot, std::vector<Vector2>{{3.5, 4.5}, {9, 4.5}}, [&] {
    localizer.move(last.inverse() * robot.odometry());
    last = robot.odometry();
    std::vector<RangeBeam> rays = robot.beams();
    std::erase_if(rays, [](const RangeBeam& beam) { return beam.openingAngle > 0; });
    localizer.see(rays);
  });
  EXPECT_LT((localizer.estimate().robotInField.translation() - robot.pose().translation()).norm(), 0.2);
  EXPECT_LT(localizer.estimate().positionDeviation, 0.3);
}

TEST(Mapping, parametersActWhileItRuns) {
  MappedBuilding building("scan-matching", 0);
  building.drive(std::vector<Vector2>{{3, 4.5}});
  auto& parameters = building.mapper().parametersAs<robotcontrol::ScanMatchingParameters>();
  parameters.set_least_way(1000);
  parameters.set_least_turn(1000);
  building.sense();
  for (int i = 0; i < 12; ++i) {
    building.robot().drive({});
    building.sense();
  }
  const std::string before = building.grid().data();
  building.drive(std::vector<Vector2>{{3.5, 4.5}, {3.5, 2}});
  EXPECT_EQ(before, building.grid().data()) << "no scan is added any more";
  parameters.set_least_way(0);
  for (int i = 0; i < 12; ++i) {
    building.robot().drive({});
    building.sense();
  }
  EXPECT_NE(before, building.grid().data());
}

TEST(Mapping, everythingThatItShowsIsThere) {
  for (const char* solution : {"odometry", "scan-matching"}) {
    MappedBuilding building(solution, 0.02);
    building.mapper().switchOnKeys();
    building.drive(std::vector<Vector2>{{2.5, 4.5}});
    EXPECT_THAT(building.mapper().silentKeys(), IsEmpty()) << solution;
  }
}

TEST(Mapping, isNotDisturbedByOdometryThatIsSetToZeroOrNoNumber) {
  MappedBuilding building("scan-matching", 0);
  building.drive(std::vector<Vector2>{{4, 4.5}});
  const double before = building.error();
  robotcontrol::DriveState bad = driveState(building.robot());
  bad.mutable_odometry()->set_x(std::numeric_limits<double>::quiet_NaN());
  building.mapper().set(robotlink::kDriveState, bad);
  building.mapper().execute();
  bad.mutable_odometry()->set_x(-30);
  building.mapper().set(robotlink::kDriveState, bad);
  building.mapper().execute();
  EXPECT_LT(building.error(), before + 0.15);
}

}  // namespace
}  // namespace modules
