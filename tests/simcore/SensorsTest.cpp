// SPDX-License-Identifier: GPL-3.0-or-later
// Sensors of numbers, their errors, and ports, in whole simulations.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simcore/SensorScenes.h"

namespace simcore {
namespace {

void run(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.step();
}

std::vector<double> reading(const Simulation& simulation, const std::string& path) {
  auto values = simulation.read(path);
  EXPECT_TRUE(values) << path;
  return values ? *values : std::vector<double>(6);
}

std::vector<double> truth(const Simulation& simulation, const std::string& path) {
  auto values = simulation.readTruth(path);
  EXPECT_TRUE(values) << path;
  return values ? *values : std::vector<double>(6);
}

std::string custom(const std::string& name, const std::string& contents) {
  return "<sensor name='" + name + "' type='custom'>" + contents + "</sensor>";
}

constexpr const char* kGuided =
    "<robotcontrol:guided kind='omni'><robotcontrol:acceleration>20</robotcontrol:acceleration>"
    "</robotcontrol:guided>";

/// An arm on the cart that turns about y, 0.2 kg at 0.3 m.
std::string armWith(const std::string& inJoint,
                    const std::string& limit = "<effort>5</effort><velocity>4</velocity>") {
  return R"(<link name="arm"><pose>0 0 0.5 0 0 0</pose>
      <inertial><pose>0.3 0 0 0 0 0</pose><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz>
      <ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link>
    <joint name="shoulder" type="revolute"><parent>base</parent><child>arm</child>
      <axis><xyz>0 -1 0</xyz><limit><lower>-1.5</lower><upper>1.5</upper>)" +
         limit + "</limit></axis>" + inJoint + "</joint>";
}

TEST(SensorsTest, magnetometersTurnWithTheRobot) {
  const auto simulation =
      cartWith("<sensor name='compass' type='magnetometer'><pose>0 0 0 0 0 1.5707963</pose></sensor>", "",
               "<magnetic_field>2e-5 0 -4e-5</magnetic_field>");
  ASSERT_TRUE(simulation);
  const auto field = reading(*simulation, "cart/compass");
  EXPECT_NEAR(field[0], 0, 1e-10);
  EXPECT_NEAR(field[1], -2e-5, 1e-10);
  EXPECT_NEAR(field[2], -4e-5, 1e-10);
}

TEST(SensorsTest, navSatMeasuresInTheWorldWithTheNoiseOfItsAxes) {
  const auto simulation = cartWith(R"(<sensor name="gps" type="navsat"><navsat><position_sensing>
      <horizontal><noise type="gaussian"><mean>0</mean><stddev>0.5</stddev></noise></horizontal>
      <vertical><noise type="gaussian"><mean>2</mean><stddev>0</stddev></noise></vertical>
    </position_sensing></navsat></sensor>)");
  ASSERT_TRUE(simulation);
  run(*simulation, 50);
  const auto measured = reading(*simulation, "cart/gps"), exact = truth(*simulation, "cart/gps");
  EXPECT_NEAR(exact[2], 0.05, 0.002);
  EXPECT_NE(measured[0], exact[0]);
  EXPECT_NE(measured[0] - exact[0], measured[1] - exact[1]);
  EXPECT_NEAR(measured[2], exact[2] + 2, 1e-12);
  EXPECT_EQ(measured[3], exact[3]);
}

TEST(SensorsTest, odometryOfAGuidedModelAddsUpItsSteps) {
  const auto simulation = cartWith(
      custom("odometry", "<robotcontrol:odometry/>") + "<sensor name='height' type='altimeter'/>", kGuided);
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->placeModel("cart", {1, 2, 1.5707963}));
  const std::vector<double> forwards{0.5, 0, 0};
  ASSERT_TRUE(simulation->write("cart/motion", forwards));
  run(*simulation, 250);
  const auto odometry = reading(*simulation, "cart/odometry");
  const Eigen::Vector3d pose = simulation->modelPose("cart")->translation();
  EXPECT_NEAR(pose.y() - 2, 0.49, 0.02);
  EXPECT_NEAR(odometry[0], pose.y() - 2, 0.005) << "it went forwards, wherever it was put";
  EXPECT_NEAR(odometry[1], 0, 0.01);
  EXPECT_NEAR(reading(*simulation, "cart/height")[0], 0, 0.002);
}

TEST(SensorsTest, aWhiskerAndASwitchTouch) {
  const auto simulation = cartWith(
      custom("whisker", "<pose>0.2 0 0 0 0 0</pose><robotcontrol:whisker>0.15</robotcontrol:whisker>") +
          custom("foot", "<robotcontrol:switch/>"),
      kGuided, solidAt("wall", "1 0 0.25 0 0 0", "0.2 2 0.5"));
  ASSERT_TRUE(simulation);
  run(*simulation, 25);
  EXPECT_EQ(reading(*simulation, "cart/whisker")[0], 0);
  EXPECT_EQ(reading(*simulation, "cart/foot")[0], 1) << "it stands on the ground";
  ASSERT_TRUE(simulation->placeModel("cart", {0.6, 0, 0}));
  EXPECT_EQ(reading(*simulation, "cart/whisker")[0], 1);
}

TEST(SensorsTest, aJointFeelsItsSpeedAndTheWeightThatItHolds) {
  const auto simulation = cartWith("", armWith(R"(<robotcontrol:servo/>
      <robotcontrol:speed_sensor/>
      <robotcontrol:load_sensor><robotcontrol:precision>0.01</robotcontrol:precision></robotcontrol:load_sensor>
      <sensor name="wrist" type="force_torque"/>)"));
  ASSERT_TRUE(simulation);
  run(*simulation, 250);
  // The solver's forces of one step are some percent beside those of the next one.
  constexpr int kSteps = 50;
  double torque = 0, force = 0;
  for (int i = 0; i < kSteps; ++i) {
    run(*simulation, 1);
    torque += std::abs(truth(*simulation, "cart/shoulder/load")[0]) / kSteps;
    force += reading(*simulation, "cart/wrist")[2] / kSteps;
  }
  const double weight = 0.2 * 9.81;
  EXPECT_NEAR(torque, 0.3 * weight, 0.02);
  EXPECT_NEAR(force, -weight, 0.05) << "the arm pulls the cart down";
  const double load = reading(*simulation, "cart/shoulder/load")[0] * 100;
  EXPECT_NEAR(load, std::round(load), 1e-9);
  simulation->requestAngle(0, 1);
  run(*simulation, 20);
  EXPECT_NEAR(reading(*simulation, "cart/shoulder/speed")[0], 4, 0.5);
}

TEST(SensorsTest, aFixedJointFeelsTheWeightThatItHolds) {
  const auto simulation = cartWith("", R"(<link name="arm"><pose>0 0 0.5 0 0 0</pose>
      <inertial><pose>0.3 0 0 0 0 0</pose><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz>
      </inertia></inertial></link>
    <joint name="mount" type="fixed"><parent>base</parent><child>arm</child>
      <sensor name="wrist" type="force_torque"/></joint>)");
  ASSERT_TRUE(simulation);
  run(*simulation, 250);
  double force = 0, torque = 0;
  constexpr int kSteps = 50;
  for (int i = 0; i < kSteps; ++i) {
    run(*simulation, 1);
    force += reading(*simulation, "cart/wrist")[2] / kSteps;
    torque += reading(*simulation, "cart/wrist")[4] / kSteps;
  }
  const double weight = 0.2 * 9.81;
  EXPECT_NEAR(force, -weight, 0.05);
  EXPECT_NEAR(torque, 0.3 * weight, 0.02);
}

TEST(SensorsTest, aBatteryIsDrainedByTimeAndByWork) {
  const std::string battery = custom(
      "battery",
      "<robotcontrol:battery><robotcontrol:capacity>100"
      "</robotcontrol:capacity><robotcontrol:idle_power>10</robotcontrol:idle_power></robotcontrol:battery>");
  const auto resting = cartWith(battery, armWith("<robotcontrol:servo/>"));
  const auto working = cartWith(battery, armWith("<robotcontrol:servo/>"));
  ASSERT_TRUE(resting && working);
  EXPECT_EQ(reading(*resting, "cart/battery")[1], 1);
  for (int i = 0; i < 250; ++i) {
    if (i % 50 == 0) working->requestAngle(0, i % 100 == 0 ? 1.4 : -1.4);
    resting->step();
    working->step();
  }
  EXPECT_NEAR(reading(*resting, "cart/battery")[1], 0.9, 0.005);
  EXPECT_LT(reading(*working, "cart/battery")[1], 0.89);
  EXPECT_NEAR(reading(*resting, "cart/battery")[0], 11.8, 0.02);
  run(*resting, 2500);
  EXPECT_EQ(reading(*resting, "cart/battery")[1], 0) << "it is empty, not less";
}

TEST(SensorsTest, delayRateAndNoiseOfTheSceneAreThoseOfTheReadings) {
  const auto simulation = cartWith(custom("odometry", R"(<robotcontrol:odometry/>
      <robotcontrol:delay>0.04</robotcontrol:delay><robotcontrol:rate>25</robotcontrol:rate>)"),
                                   kGuided);
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->write("cart/motion", std::vector<double>{0.5, 0, 0}));
  std::vector<double> exact{truth(*simulation, "cart/odometry")[0]};
  for (int step = 1; step <= 100; ++step) {
    simulation->step();
    exact.push_back(truth(*simulation, "cart/odometry")[0]);
    const int shown = std::max(0, (step - 10) / 10 * 10);
    ASSERT_EQ(reading(*simulation, "cart/odometry")[0], exact[static_cast<std::size_t>(shown)]) << step;
  }
}

TEST(SensorsTest, aReadingDoesNotDependOnWhatElseIsReadOrHowOften) {
  const std::string sensors =
      custom("odometry",
             "<robotcontrol:odometry/><robotcontrol:noise>0.1</robotcontrol:noise>"
             "<robotcontrol:drift_stddev>1</robotcontrol:drift_stddev><robotcontrol:drift_time>2</"
             "robotcontrol:drift_time>"
             "<robotcontrol:dropout>0.2</robotcontrol:dropout>");
  const auto often = cartWith(sensors, kGuided);
  const auto seldom = cartWith("<sensor name='compass' type='magnetometer'/>" + sensors, kGuided);
  ASSERT_TRUE(often && seldom);
  for (int step = 0; step < 200; ++step) {
    often->step();
    seldom->step();
    reading(*often, "cart/odometry");
    truth(*often, "cart/odometry");
  }
  EXPECT_EQ(reading(*often, "cart/odometry"), reading(*seldom, "cart/odometry"));
}

TEST(SensorsTest, noiseCanBeChosenWhileTheSimulationRuns) {
  const auto simulation = cartWith("<sensor name='height' type='altimeter'/>", "", "", {.noise = false});
  ASSERT_TRUE(simulation);
  run(*simulation, 10);
  EXPECT_EQ(reading(*simulation, "cart/height"), truth(*simulation, "cart/height"));
  ASSERT_TRUE(simulation->setSensorErrors("cart/height", {.noise = {{.mean = 3}}}));
  EXPECT_NEAR(reading(*simulation, "cart/height")[0], truth(*simulation, "cart/height")[0] + 3, 1e-12);
  EXPECT_EQ(simulation->sensorErrors("cart/height")->of(1).mean, 3);
  simulation->reset(2);
  EXPECT_NEAR(reading(*simulation, "cart/height")[0], 3, 1e-12) << "a reset keeps it";
  const auto unknown = simulation->setSensorErrors("cart/depth", {});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().id, "simulation.unknown-port");
  const auto wrong = simulation->setSensorErrors("cart/height", {{}, -1, 0, 0});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().id, "simulation.noise");
}

TEST(SensorsTest, everythingIsAPortThatIsFoundByItsPath) {
  const auto simulation = cartWith("<sensor name='height' type='altimeter'/>",
                                   armWith("<robotcontrol:servo/>") + std::string(kGuided));
  ASSERT_TRUE(simulation);
  for (const Port& port : simulation->ports()) {
    ASSERT_EQ(simulation->port(port.info.path), &port);
    const auto values = simulation->read(port.info.path);
    ASSERT_TRUE(values) << port.info.path;
    std::size_t size = 1;
    for (const int dimension : port.info.shape) size *= static_cast<std::size_t>(dimension);
    EXPECT_EQ(values->size(), port.isActuator() ? 2 : size) << port.info.path;
  }
  EXPECT_EQ(simulation->port("cart/shoulder/request")->info.unit, "rad");
  EXPECT_EQ(simulation->port("cart/shoulder/request")->info.maximum, 1.5);
  EXPECT_EQ(simulation->port("cart/motion")->info.shape, std::vector{3});
  EXPECT_NEAR(truth(*simulation, "cart/true_pose")[2], 0.05, 1e-6);
  EXPECT_FALSE(simulation->read("cart/nothing"));
  EXPECT_FALSE(simulation->write("cart/height", std::vector<double>{1}));
  EXPECT_FALSE(simulation->write("cart/motion", std::vector<double>{1}));
}

TEST(SensorsTest, sensorsThatAreNotKnownAreLeftOut) {
  const auto simulation =
      cartWith("<sensor name='s' type='custom'/>", R"(<link name="arm"><pose>0 0 1 0 0 0</pose></link>
      <joint name="shoulder" type="ball"><parent>base</parent><child>arm</child>
        <sensor name="wrist" type="force_torque"/><sensor name="skin" type="contact"/></joint>)");
  ASSERT_TRUE(simulation);
  std::vector<std::string> left;
  for (const LeftOut& each : simulation->scene().leftOut()) left.push_back(each.what);
  for (const char* what :
       {"sensor of type 'custom'", "force_torque sensor 'wrist'", "sensor of type 'contact'"}) {
    EXPECT_EQ(std::ranges::count(left, std::string(what)), 1) << what;
  }
}

TEST(SensorsTest, aForceBetweenLinksThatAreOneBodyAnywayIsLeftOut) {
  const auto simulation = cartWith(
      "", R"(<link name="arm"><pose>0 0 1 0 0 0</pose></link><link name="hand"><pose>0 0 2 0 0 0</pose></link>
      <joint name="mount" type="fixed"><parent>base</parent><child>arm</child><sensor name="wrist" type="force_torque"/></joint>
      <joint name="rod" type="fixed"><parent>arm</parent><child>hand</child></joint>
      <joint name="brace" type="fixed"><parent>base</parent><child>hand</child></joint>)");
  ASSERT_TRUE(simulation);
  EXPECT_EQ(simulation->port("cart/wrist"), nullptr);
  const auto& left = simulation->scene().leftOut();
  const auto wrist = std::ranges::find(left, "force_torque sensor 'wrist'", &LeftOut::what);
  ASSERT_NE(wrist, left.end());
  EXPECT_EQ(wrist->why, "other fixed joints connect the links of its joint as well");
  EXPECT_GT(wrist->where.line, 1);
}

TEST(SensorsTest, sensorsOfOneNameInSeveralLinksAreNamedAfterThem) {
  const auto simulation = cartWith("<sensor name='imu' type='imu'/>", R"(<link name="arm">
      <pose>0 0 1 0 0 0</pose><sensor name="imu" type="imu"/><sensor name="gps" type="navsat"/></link>
      <joint name="shoulder" type="fixed"><parent>base</parent><child>arm</child></joint>)");
  ASSERT_TRUE(simulation);
  for (const char* path : {"cart/base::imu", "cart/arm::imu", "cart/gps"})
    EXPECT_NE(simulation->port(path), nullptr) << path;
  EXPECT_EQ(simulation->port("cart/imu"), nullptr);
  EXPECT_EQ(simulation->port("cart/arm::imu")->info.maximum, 0) << "without a range it is not known";
}

TEST(SensorsTest, aStaticModelLooksAround) {
  const auto simulation = cartWith("", "", R"(
    <model name="pole"><static>true</static><pose>-2 0 0.05 0 0 0</pose><link name="head"><pose>0.5 0 0 0 0 0</pose>
      <sensor name="eye" type="camera"><update_rate>10</update_rate>
        <camera><horizontal_fov>1</horizontal_fov><image><width>40</width><height>30</height></image></camera></sensor>
      <sensor name="scanner" type="gpu_lidar"><update_rate>10</update_rate><lidar><scan><horizontal><samples>3</samples>
        <min_angle>-0.1</min_angle><max_angle>0.1</max_angle></horizontal></scan>
        <range><min>0.1</min><max>10</max></range></lidar></sensor>
      <sensor name="compass" type="magnetometer"/></link></model>)",
                                   {.noise = false});
  ASSERT_TRUE(simulation);
  run(*simulation, 1);
  // The cart's front is 1.3 m before it.
  const auto ranges = reading(*simulation, "pole/scanner");
  ASSERT_EQ(ranges.size(), 3U);
  EXPECT_NEAR(ranges[1], 1.3, 1e-3);
  ASSERT_EQ(simulation->cameras().size(), 1U);
  EXPECT_EQ(simulation->cameras()[0].info.path, "pole/eye/image");
  const auto percepts = simulation->truePercepts(0);
  EXPECT_TRUE(std::ranges::any_of(percepts, [](const TruePercept& each) { return each.model == "cart"; }));
  EXPECT_FALSE(simulation->read("pole/compass"));
  EXPECT_TRUE(std::ranges::any_of(simulation->scene().leftOut(), [](const LeftOut& each) {
    return each.what == "sensor 'compass' of a static model";
  }));
}

TEST(SensorsTest, whatIsWrongOfSensorsIsLeftOutWithItsLine) {
  const SceneFolder folder;
  const auto leftOutOf = [&](const std::string& sensor) {
    const auto scene = Scene::load(folder.write(
        "world.sdf", worldAround("<model name='m'><link name='l'>\n" + sensor + "</link></model>")));
    EXPECT_TRUE(scene) << (scene ? "" : describe(scene.error()));
    const LeftOuts left = scene ? (*scene)->leftOut() : LeftOuts();
    EXPECT_EQ(left.size(), 1U);
    return left.empty() ? LeftOut() : left[0];
  };
  const LeftOut dropout = leftOutOf(
      "<sensor name='s' "
      "type='custom'><robotcontrol:odometry/>\n<robotcontrol:dropout>2</robotcontrol:dropout>"
      "</sensor>");
  EXPECT_EQ(dropout.what, "<robotcontrol:dropout>");
  EXPECT_EQ(dropout.why, "dropout must be between 0 and 1, not 2");
  EXPECT_EQ(dropout.where.line, 5);
  EXPECT_EQ(dropout.object, "m/l/s");
  const LeftOut facette = leftOutOf("<sensor name='s' type='custom'><robotcontrol:facette/></sensor>");
  EXPECT_EQ(facette.what, "sensor 's'");
  EXPECT_NE(facette.why.find("azimuth"), std::string::npos);
}

}  // namespace
}  // namespace simcore
