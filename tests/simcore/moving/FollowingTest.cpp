// SPDX-License-Identifier: GPL-3.0-or-later
// Models that are moved as they are commanded, without forces: walking robots by the odometry model of their
// gait, vehicles, guided ones.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simcore/moving/MovingScenes.h"

namespace simcore {
namespace {

using robotlink::Pose2;

constexpr const char* kMovedKinematically = "<robotcontrol:motion>kinematic</robotcontrol:motion>";
constexpr const char* kStops = "<robotcontrol:motion objects='stop'>kinematic</robotcontrol:motion>";

std::string walker(const std::string& motion = kMovedKinematically) {
  return including("ers210", "0 0 0.1136 0 0 0", motion);
}

TEST(Following, aWalkingRobotMovesAsItsGaitWouldHaveMovedIt) {
  const auto simulation = yardWith(walker());
  commandPort(*simulation, "ers210/walk", {0.1, 0, 0});
  runFor(*simulation, 1);
  const Pose2 before = groundPlace(*simulation, "ers210");
  runFor(*simulation, 5);
  const Pose2 after = groundPlace(*simulation, "ers210");
  EXPECT_NEAR(after.x - before.x, 0.5 * 1.02, 1e-6) << "with the slip that its model states";
  EXPECT_NEAR(after.y, 0, 1e-9) << "without noise";
  EXPECT_NEAR(after.heading, 0, 1e-9);
}

TEST(Following, turningAndWalkingMakeACircle) {
  const auto simulation = yardWith(walker("<robotcontrol:motion>kinematic</robotcontrol:motion>"));
  commandPort(*simulation, "ers210/walk", {0.1, 0, 0.5});
  runFor(*simulation, 3);
  const auto velocity = simulation->read("ers210/true_velocity").value();
  EXPECT_NEAR(std::hypot(velocity[0], velocity[1]) / velocity[5], 0.2, 0.03);
}

TEST(Following, itsLegsTurnAsTheirServosAreCommandedAndItStandsOnTheGround) {
  const auto simulation = yardWith(walker());
  const double height = simulation->modelPose("ers210")->translation().z();
  const double before = portReading(*simulation, "ers210/legFL3/position");
  commandPort(*simulation, "ers210/legFL3/request", {before - 0.4});
  commandPort(*simulation, "ers210/headPan/request", {0.5});
  runFor(*simulation, 1);
  EXPECT_NEAR(portReading(*simulation, "ers210/legFL3/position"), before - 0.4, 0.02);
  EXPECT_NEAR(portReading(*simulation, "ers210/headPan/position"), 0.5, 0.02);
  EXPECT_NEAR(simulation->modelPose("ers210")->linear()(2, 2), 1, 1e-9) << "it does not tilt";
  EXPECT_NEAR(simulation->modelPose("ers210")->translation().z(), height, 0.03);
  // At rest it measures gravity.
  EXPECT_NEAR(simulation->read("ers210/accelerometer").value()[2], 9.81, 0.1);
}

TEST(Following, withNoiseItErrsAsItsModelSays) {
  const auto end = [](std::uint64_t seed) {
    const auto simulation = yardWith(walker(), seed, {.seed = 1, .noise = true});
    commandPort(*simulation, "ers210/walk", {0.1, 0, 0});
    runFor(*simulation, 4);
    return groundPlace(*simulation, "ers210");
  };
  EXPECT_EQ(end(1), end(1));
  EXPECT_NE(end(1).x, end(2).x);
  EXPECT_NEAR(end(1).x, end(2).x, 0.1);
}

TEST(Following, itPushesAParcelAndStopsAtAWall) {
  const auto simulation =
      yardWith(walker() + parcelAt("parcel", 0.35, 0) + boxAt("wall", {1.05, 0, 0.25}, {0.1, 2, 0.5}));
  commandPort(*simulation, "ers210/walk", {0.15, 0, 0});
  runFor(*simulation, 3);
  EXPECT_GT(groundPlace(*simulation, "parcel").x, 0.5);
  EXPECT_EQ(simulation->read("ers210/walk").value()[1], 0) << "it has touched something";
  runFor(*simulation, 8);
  EXPECT_LT(groundPlace(*simulation, "parcel").x, 0.92) << "the wall is behind it";
  EXPECT_LT(groundPlace(*simulation, "ers210").x, 0.9) << "before it as well";
  commandPort(*simulation, "ers210/walk", {-0.15, 0, 0});
  const double before = groundPlace(*simulation, "ers210").x;
  runFor(*simulation, 2);
  EXPECT_LT(groundPlace(*simulation, "ers210").x, before - 0.2) << "it can walk away";
}

TEST(Following, aSceneMayLetItStopAtObjects) {
  const auto simulation = yardWith(walker(kStops) + parcelAt("parcel", 0.35, 0));
  commandPort(*simulation, "ers210/walk", {0.15, 0, 0});
  runFor(*simulation, 4);
  EXPECT_NEAR(groundPlace(*simulation, "parcel").x, 0.35, 0.005);
  EXPECT_LT(groundPlace(*simulation, "ers210").x, 0.2);
}

TEST(Following, aVehicleFollowsToo) {
  const auto simulation = yardWith(including("car", "0 0 0 0 0 0", kMovedKinematically) +
                                   including("omni", "0 1.5 0 0 0 0", kStops) + parcelAt("parcel", 1, 1.5));
  commandPort(*simulation, "car/drive", {0.3, 0.4});
  commandPort(*simulation, "omni/drive", {0.3, 0, 0});
  runFor(*simulation, 4);
  const auto velocity = simulation->read("car/true_velocity").value();
  EXPECT_NEAR(std::hypot(velocity[0], velocity[1]) / velocity[5], 0.32 / std::tan(0.4), 1e-3);
  EXPECT_NEAR(portReading(*simulation, "car/kingpinL/position"), 0.46, 0.1) << "it shows how it is steered";
  EXPECT_GT(portReading(*simulation, "car/axleRR/position"), 10);
  EXPECT_NEAR(groundPlace(*simulation, "omni").x, 1 - 0.1 - 0.246, 0.02) << "it stops at the parcel";
  EXPECT_NEAR(groundPlace(*simulation, "parcel").x, 1, 0.001);
}

TEST(Following, aDriveIsMovedAsItsIncludeSays) {
  // One robot by forces and one by its odometry, in one scene: only the latter stops as soon as it is told
  // to.
  const auto simulation =
      yardWith("<include><uri>model://p3at</uri><name>a</name>" + std::string(kMovedKinematically) +
               "</include><include><uri>model://p3at</uri><name>b</name><pose>0 2 0 0 0 0</pose></include>");
  const auto drive = [&](double speed, double seconds) {
    commandPort(*simulation, "a/drive", {speed, speed});
    commandPort(*simulation, "b/drive", {speed, speed});
    runFor(*simulation, seconds);
  };
  drive(0.4, 2);
  const Pose2 a = groundPlace(*simulation, "a"), b = groundPlace(*simulation, "b");
  EXPECT_NEAR(a.x, 0.8, 1e-9);
  EXPECT_NEAR(b.x, 0.8, 0.05);
  drive(0, 0.5);
  EXPECT_EQ(groundPlace(*simulation, "a").x, a.x);
  EXPECT_GT(groundPlace(*simulation, "b").x, b.x + 0.005);
}

TEST(Following, whatIsPutIntoTheAirComesDownToWhatIsBelow) {
  const auto simulation = yardWith(walker() + including("p3at", "0 3 0.5 0 0 0", kMovedKinematically) +
                                   including("car", "0 -3 0 0 0 0", kMovedKinematically) +
                                   boxAt("table", {3, 0, 0.2}, {1, 1, 0.4}));
  const auto height = [&](const char* model) { return simulation->modelPose(model)->translation().z(); };
  runFor(*simulation, 0.1);
  const double standing = height("ers210");
  EXPECT_NEAR(height("p3at"), 0, 0.01) << "its scene has put it there";
  ASSERT_TRUE(simulation->placeModel("ers210", {1, 0, 0}, ModelPosture{.height = 1}));
  ASSERT_TRUE(simulation->placeModel("p3at", {1, 3, 0}, ModelPosture{.height = 1}));
  ASSERT_TRUE(simulation->placeModel("car", {3, 0, 0}, ModelPosture{.height = 1}));
  commandPort(*simulation, "p3at/drive", {0.2, 0.2});
  runFor(*simulation, 1);
  EXPECT_NEAR(height("ers210"), standing, 1e-3);
  EXPECT_NEAR(height("p3at"), 0, 0.01);
  EXPECT_NEAR(groundPlace(*simulation, "p3at").x, 1.2, 0.01);
  EXPECT_NEAR(height("car"), 0.4, 0.01);
}

TEST(Following, whatComesDownStaysOnTheEdgeOfATable) {
  // The edge is below the left flank of the robot, beyond the middle of its wheels.
  const auto simulation = yardWith(including("p3at", "0 0 0 0 0 0", kMovedKinematically) +
                                   boxAt("table", {0, 3, 0.2}, {1, 1, 0.4}));
  ASSERT_TRUE(simulation->placeModel("p3at", {0, 2.265, 0}, ModelPosture{.height = 1}));
  runFor(*simulation, 0.1);
  EXPECT_NEAR(simulation->modelPose("p3at")->translation().z(), 0.3, 0.002);
}

/// A kinematic arm that turns a boom of 0.7 m at a height of 0.1 m, on a base of 0.1 m.
const char* const kTurningArm =
    "<model name='arm'><robotcontrol:motion>kinematic</robotcontrol:motion><link name='base'>"
    "<inertial><mass>1</mass></inertial><collision name='c'><pose>0 0 0.1 0 0 0</pose><geometry><box>"
    "<size>0.1 0.1 0.2</size></box></geometry></collision></link><joint name='foot' type='fixed'>"
    "<parent>world</parent><child>base</child></joint><link name='boom'><inertial><mass>5</mass></inertial>"
    "<collision name='c'><pose>0.4 0 0.1 0 0 0</pose><geometry><box><size>0.6 0.04 0.04</size></box>"
    "</geometry></collision></link><joint name='turn' type='revolute'><parent>base</parent>"
    "<child>boom</child><axis><xyz>0 0 "
    "1</xyz><limit><lower>-3</lower><upper>3</upper><velocity>1</velocity>"
    "<effort>0.001</effort></limit></axis><robotcontrol:servo/></joint></model>";

TEST(Following, anArmTurnsItsJointsWithoutForces) {
  const auto simulation = yardWith(kTurningArm + parcelAt("parcel", 0.5, 0.3) +
                                   boxAt("wall", {-0.5, 0.5, 0.25}, {0.1, 0.6, 0.5}));
  commandPort(*simulation, "arm/turn/request", {-1.5});
  runFor(*simulation, 2);
  EXPECT_NEAR(portReading(*simulation, "arm/turn/position"), -1.5, 1e-3) << "however weak its motor is";
  commandPort(*simulation, "arm/turn/request", {2.9});
  runFor(*simulation, 6);
  EXPECT_GT(groundPlace(*simulation, "parcel").y, 0.4) << "it pushes what can be moved";
  EXPECT_LT(portReading(*simulation, "arm/turn/position"), 2.5) << "the wall stops it";
  EXPECT_NEAR(simulation->modelPose("arm")->translation().norm(), 0, 1e-9);
  commandPort(*simulation, "arm/turn/request", {0});
  runFor(*simulation, 4);
  EXPECT_NEAR(portReading(*simulation, "arm/turn/position"), 0, 1e-3);
}

TEST(Following, anArmWhoseBaseIsInsideOfSomethingStillStopsAtOtherThings) {
  const auto stopsAt = [](const std::string& socket) {
    const auto simulation =
        yardWith(kTurningArm + socket + boxAt("wall", {-0.5, 0.5, 0.25}, {0.1, 0.6, 0.5}));
    commandPort(*simulation, "arm/turn/request", {2.9});
    runFor(*simulation, 4);
    EXPECT_EQ(simulation->read("arm/turn/request").value()[1], 0) << "it has touched something";
    const double angle = portReading(*simulation, "arm/turn/position");
    commandPort(*simulation, "arm/turn/request", {0});
    runFor(*simulation, 4);
    EXPECT_NEAR(portReading(*simulation, "arm/turn/position"), 0, 1e-3) << "it can turn away";
    return angle;
  };
  const double alone = stopsAt("");
  EXPECT_LT(alone, 2.3);
  EXPECT_NEAR(stopsAt(boxAt("socket", {-0.02, 0, 0.025}, {0.1, 0.1, 0.05})), alone, 1e-6);
}

TEST(Following, whatCannotFollowIsSaid) {
  const auto text = errorsOfModel("ball", "<robotcontrol:ball>",
                                  "<robotcontrol:motion>kinematic</robotcontrol:motion><robotcontrol:ball>");
  EXPECT_NE(text.find("can move kinematically"), std::string::npos) << text;
  const auto wrong =
      errorsOfModel("car", "<robotcontrol:vehicle",
                    "<robotcontrol:motion>by magic</robotcontrol:motion><robotcontrol:vehicle");
  EXPECT_NE(wrong.find("is physics or kinematic"), std::string::npos) << wrong;
}

TEST(Unobstructed, onlyTheActuatorThatMovesSomethingIntoTheWayIsObstructed) {
  // The left fore leg is swung against a wall; the other one and the tail are not.
  const auto simulation =
      yardWith(including("ers210", "0 0 0.1136 0 0 0") + boxAt("wall", {0.19, 0.12, 0.2}, {0.1, 0.14, 0.4}));
  for (const char* joint : {"legFL1", "legFR1", "tailPan"}) {
    const std::string path = std::string("ers210/") + joint + "/request";
    commandPort(*simulation, path, {portReading(*simulation, std::string("ers210/") + joint + "/position")});
  }
  commandPort(*simulation, "ers210/legFL1/request", {1.6});
  commandPort(*simulation, "ers210/legFL3/request", {0});
  runFor(*simulation, 2);
  EXPECT_EQ(simulation->read("ers210/legFL1/request").value()[1], 0) << "it touches the wall";
  EXPECT_EQ(simulation->read("ers210/legFL3/request").value()[1], 0) << "so does what this joint moves";
  EXPECT_EQ(simulation->read("ers210/tailPan/request").value()[1], 1);
  EXPECT_EQ(simulation->read("ers210/legFR1/request").value()[1], 1);
}

}  // namespace
}  // namespace simcore
