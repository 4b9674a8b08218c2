// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/RangeSensor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "simcore/Simulation.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using robotlink::radians;
using testing::HasSubstr;

/// A cart with a sonar and a laser of 19 readings at 0.3 m height, 0.2 m before its center.
const char* const kCart = R"(<?xml version="1.0"?>
<sdf version="1.9" xmlns:robotcontrol="urn:robotcontrol:sdf">
  <model name="cart">
    <link name="body">
      <inertial><pose>0 0 0.2 0 0 0</pose><mass>20</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>
      <collision name="box"><pose>0 0 0.25 0 0 0</pose><geometry><box><size>0.5 0.4 0.5</size></box></geometry></collision>
      <visual name="box"><pose>0 0 0.25 0 0 0</pose><geometry><box><size>0.5 0.4 0.5</size></box></geometry></visual>
      <sensor name="sonar" type="sonar"><pose>0.2 0 0.3 0 0 0</pose><sonar><min>0.1</min><max>5</max><radius>1.33975</radius></sonar></sensor>
      <sensor name="laser" type="lidar"><pose>0.2 0 0.3 0 0 0</pose><lidar><scan><horizontal><samples>19</samples><min_angle>-1.570796</min_angle><max_angle>1.570796</max_angle></horizontal></scan><range><min>0.05</min><max>30</max></range><noise><type>gaussian</type><mean>0</mean><stddev>0.005</stddev></noise></lidar></sensor>
    </link>
  </model>
</sdf>
)";

std::string box(const std::string& name, const std::string& pose, const std::string& size) {
  const std::string shape = "<geometry><box><size>" + size + "</size></box></geometry>";
  return "<model name='" + name + "'><static>true</static><pose>" + pose +
         "</pose><link name='box'><collision name='box'>" + shape + "</collision><visual name='box'>" +
         shape + "</visual></link></model>\n";
}

const char* const kFloor =
    "<model name='floor'><static>true</static><link name='floor'><collision "
    "name='floor'><geometry><plane><normal>0 0 1</normal><size>90 90</size>"
    "</plane></geometry></collision><visual name='floor'><geometry><plane><normal>0 0 1</normal><size>90 "
    "90</size></plane></geometry></visual></link></model>\n";
const char* const kCartHere = "<include><uri>model://cart</uri></include>\n";

class RangeSensorTest : public testing::Test {
 protected:
  RangeSensorTest() { folder_.writeModel("cart", kCart); }

  std::unique_ptr<Simulation> simulate(const std::string& contents,
                                       const SimulationOptions& options = {.noise = false}) {
    const auto scene = Scene::load(folder_.write("world.sdf", worldAround(kFloor + contents)));
    EXPECT_TRUE(scene) << describe(scene.error());
    scene_ = scene.value();
    return std::move(Simulation::create(scene_, options).value());
  }
  SceneFolder folder_;
  std::shared_ptr<const Scene> scene_;  // the last one
};

std::size_t indexOf(const Simulation& simulation, const std::string& path) {
  const auto sensors = simulation.rangeSensors();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].info.path == path) return i;
  }
  ADD_FAILURE() << path;
  return 0;
}

std::vector<double> measured(const Simulation& simulation, const std::string& path) {
  const std::size_t index = indexOf(simulation, path);
  std::vector<double> ranges(static_cast<std::size_t>(simulation.rangeSensors()[index].readings), -1);
  simulation.measure(index, ranges);
  return ranges;
}

double echo(const Simulation& simulation, const std::string& path = "cart/sonar") {
  return measured(simulation, path)[0];
}

TEST_F(RangeSensorTest, sensorsAreDescribed) {
  const auto simulation = simulate(kCartHere);
  ASSERT_EQ(simulation->rangeSensors().size(), 2U);
  const RangeSensor& sonar = simulation->rangeSensors()[0];
  EXPECT_EQ(sonar.info.path, "cart/sonar");
  EXPECT_EQ(sonar.info.type, "range");
  EXPECT_EQ(sonar.info.unit, "m");
  EXPECT_TRUE(sonar.info.shape.empty());
  EXPECT_EQ(sonar.kind, RangeSensor::Kind::kSonar);
  EXPECT_NEAR(sonar.openingAngle, radians(30), 1e-5);
  EXPECT_NEAR(sonar.mostIncidence, radians(55), 1e-9);
  EXPECT_EQ(sonar.maximum, 5);
  EXPECT_NEAR(sonar.sensorInBody.translation().x(), 0.2, 1e-12);
  const RangeSensor& laser = simulation->rangeSensors()[1];
  EXPECT_EQ(laser.info.shape, std::vector{19});
  EXPECT_EQ(laser.kind, RangeSensor::Kind::kLaser);
  EXPECT_EQ(laser.readings, 19);
  EXPECT_NEAR(laser.startAngle, -robotlink::kPi / 2, 1e-5);
  EXPECT_NEAR(laser.endAngle, robotlink::kPi / 2, 1e-5);
  EXPECT_EQ(laser.errors.of(0).stddev, 0.005);
}

TEST_F(RangeSensorTest, otherRobotsAreSeenWhereTheyAreAndTheOwnNever) {
  const std::string other =
      "<include><uri>model://cart</uri><name>other</name><pose>2 0 0 0 0 3.14159265</pose></include>\n";
  const auto simulation = simulate(kCartHere + other);
  const std::uint64_t digest = simulation->digest();
  EXPECT_NEAR(echo(*simulation), 1.55, 1e-3);
  EXPECT_NEAR(measured(*simulation, "other/laser")[9], 1.55, 1e-3);
  EXPECT_EQ(simulation->digest(), digest) << "to measure changes nothing";
  ASSERT_TRUE(simulation->placeModel("other", {3, 0, robotlink::kPi}));
  EXPECT_NEAR(echo(*simulation), 2.55, 1e-3);
  ASSERT_TRUE(simulation->placeModel("cart", {0, 0, robotlink::kPi / 2}));
  EXPECT_EQ(echo(*simulation), 5);
  simulation->reset(1);
  EXPECT_NEAR(echo(*simulation), 1.55, 1e-3);
}

TEST_F(RangeSensorTest, noiseFollowsTheOptionsAndTheSteps) {
  const std::string wall = box("wall", "3.5 0 1 0 0 0", "1 90 2");
  const auto simulation = simulate(kCartHere + wall, {.seed = 4});
  simulation->step();
  const std::vector<double> first = measured(*simulation, "cart/laser");
  EXPECT_EQ(measured(*simulation, "cart/laser"), first);
  simulation->step();
  EXPECT_NE(measured(*simulation, "cart/laser"), first);
  simulation->reset(4);
  simulation->step();
  EXPECT_EQ(measured(*simulation, "cart/laser"), first);
  const auto exact = std::move(Simulation::create(scene_, {.noise = false}).value());
  EXPECT_NEAR(measured(*exact, "cart/laser")[9], 2.8, 1e-5);
}

TEST_F(RangeSensorTest, olderNamesOfLasersAreKnown) {
  std::string model = replaced(kCart, "type=\"lidar\"", "type=\"ray\"");
  model = replaced(replaced(model, "<lidar>", "<ray>"), "</lidar>", "</ray>");
  folder_.writeModel("cart", model);
  folder_.writeModel("other", replaced(kCart, "type=\"lidar\"", "type=\"gpu_lidar\""));
  const std::string other =
      "<include><uri>model://other</uri><name>other</name><pose>9 0 0 0 0 0</pose></include>\n";
  EXPECT_EQ(simulate(kCartHere + other)->rangeSensors().size(), 4U);
}

TEST_F(RangeSensorTest, whatIsWrongIsSaid) {
  std::string model = replaced(kCart, "<sonar><min>0.1</min><max>5</max>",
                               "<sonar><geometry>sphere</geometry><min>0.1</min><max>0</max>");
  model =
      replaced(model, "</sonar></sensor>", "</sonar><robotcontrol:noise>-1</robotcontrol:noise></sensor>");
  model = replaced(model, "<max_angle>1.570796", "<max_angle>-2");
  model = replaced(model, "</lidar></sensor>", "</lidar><robotcontrol:delay>0</robotcontrol:delay></sensor>");
  model = replaced(model, "<samples>19", "<samples>2000000");
  folder_.writeModel("cart", model);
  const auto scene = Scene::load(folder_.write("world.sdf", worldAround(kCartHere)));
  ASSERT_TRUE(scene) << describe(scene.error());
  std::string reasons;
  for (const LeftOut& each : (*scene)->leftOut()) reasons += each.what + ": " + each.why + "\n";
  for (const char* expected :
       {"a sonar's <max> must be between", "<robotcontrol:noise>: noise must be between",
        "max_angle must be between", "a lidar's samples must be between"}) {
    EXPECT_THAT(reasons, HasSubstr(expected));
  }
}

TEST_F(RangeSensorTest, ofALidarWithSeveralPlanesOnlyItsOwnIsMeasured) {
  folder_.writeModel("cart", replaced(kCart, "</horizontal>",
                                      "</horizontal><vertical><samples>4</samples><min_angle>0</min_angle>"
                                      "<max_angle>1</max_angle></vertical>"));
  const auto scene = Scene::load(folder_.write("world.sdf", worldAround(kCartHere)));
  ASSERT_TRUE(scene) << describe(scene.error());
  ASSERT_EQ((*scene)->leftOut().size(), 1U);
  EXPECT_EQ((*scene)->leftOut()[0].what, "vertical samples of a lidar");
}

TEST_F(RangeSensorTest, aLidarOfOneRayStaysADistance) {
  folder_.writeModel("cart", replaced(kCart, "<samples>19</samples>", "<samples>1</samples>"));
  const auto simulation = simulate(kCartHere + box("wall", "3.5 0 1 0 0 0", "1 20 2"));
  EXPECT_EQ(simulation->rangeSensors().size(), 1U);
  ASSERT_EQ(simulation->sensors().size(), 1U);
  EXPECT_EQ(simulation->sensors()[0].info.type, "distance");
  EXPECT_NEAR(simulation->sensors()[0].values[0], 2.8, 1e-3);
}

TEST_F(RangeSensorTest, thePioneersSensorsAreWhereItsDescriptionSays) {
  const auto description = robotlink::readRobotDescription(robotlink::resource("robots/p3at.yaml"));
  ASSERT_TRUE(description) << describe(description.error());
  const auto simulation = simulate("<include><uri>model://p3at</uri></include>\n");
  const auto expectPose = [](const RangeSensor& sensor, const robotlink::Pose2& expected) {
    const robotlink::Pose2 pose = robotlink::groundPose(sensor.sensorInBody);
    EXPECT_NEAR(pose.x, expected.x, 1e-4) << sensor.info.path;
    EXPECT_NEAR(pose.y, expected.y, 1e-4) << sensor.info.path;
    EXPECT_NEAR(robotlink::normalizedAngle(pose.heading - expected.heading), 0, 1e-4) << sensor.info.path;
  };
  const auto& sonars = description->sonars;
  for (std::size_t i = 0; i < sonars->sensors.size(); ++i) {
    const RangeSensor& sonar =
        simulation->rangeSensors()[indexOf(*simulation, "p3at/sonar" + std::to_string(i))];
    expectPose(sonar, sonars->sensors[i].inRobot);
    EXPECT_NEAR(sonar.openingAngle, sonars->openingAngle, 1e-4);
    EXPECT_EQ(sonar.maximum, sonars->maximum);
  }
  const RangeSensor& laser = simulation->rangeSensors()[indexOf(*simulation, "p3at/laser")];
  expectPose(laser, description->laser->inRobot);
  EXPECT_EQ(laser.readings, description->laser->readings);
  EXPECT_EQ(laser.maximum, description->laser->maximum);
  EXPECT_NEAR(laser.startAngle, description->laser->startAngle, 1e-6);
  EXPECT_NEAR(laser.endAngle, description->laser->endAngle, 1e-6);
  EXPECT_EQ(simulation->rangeSensors().size(), sonars->sensors.size() + 1);
}

}  // namespace
}  // namespace simcore
