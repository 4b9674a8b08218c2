// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/WorldPorts.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <set>

#include "app/platforms/simulated/WorldChanges.h"
#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "app/platforms/simulated/world/WorldObjects.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "simcore/Scene.h"
#include "simcore/world/WorldDescription.h"
#include "tests/TestFolder.h"
#include "tests/app/SimulatedRuns.h"

namespace app {
namespace {

using robotcontrol::WorldObject;
using testing::HasSubstr;

/// The shipped scene with one robot, which stands still.
class WorldPortsTest : public testing::Test {
 protected:
  WorldPortsTest() : run_(test::makeRun(test::simulationOptions())), ports_(run_->world()) {}

  const simcore::Simulation& simulation() const { return run_->world().simulation(); }
  robotlink::Result<void> hold(const std::string& port, std::vector<double> values) {
    robotcontrol::SetActuator set;
    set.set_port(port);
    for (const double value : values) set.add_values(value);
    return ports_.set({}, set, stopped_);
  }
  const WorldObject* object(const robotcontrol::WorldObjects& all, const std::string& path) const {
    const auto found = std::ranges::find(all.objects(), path, &WorldObject::path);
    return found == all.objects().end() ? nullptr : &*found;
  }

  const std::unique_ptr<SimulatedRun> run_;
  WorldPorts ports_;
  std::vector<std::string> stopped_;
};

TEST_F(WorldPortsTest, allObjectsHaveAPathOfTheirOwnAndAParentThatExists) {
  const auto all = worldObjects(simulation());
  std::set<std::string> paths;
  for (const auto& each : all->objects()) EXPECT_TRUE(paths.insert(each.path()).second) << each.path();
  for (const auto& each : all->objects())
    EXPECT_TRUE(each.parent().empty() || paths.contains(each.parent())) << each.path();
  for (const auto& model : simulation().scene().world().models) EXPECT_TRUE(paths.contains(model.name));
  for (const auto& sensor : simulation().sensors()) EXPECT_TRUE(paths.contains(sensor.info.path));
  for (const auto& servo : simulation().servos()) EXPECT_TRUE(paths.contains(servo.info.path));
}

TEST_F(WorldPortsTest, portsLieBelowWhatTheyBelongTo) {
  const auto all = worldObjects(simulation());
  const WorldObject* servo = object(*all, "red1/legFL1/request");
  ASSERT_NE(servo, nullptr);
  EXPECT_EQ(servo->kind(), WorldObject::ACTUATOR);
  EXPECT_EQ(servo->parent(), "red1/joint:legFL1");
  EXPECT_EQ(servo->port().unit(), "rad");
  EXPECT_LT(servo->port().minimum(), servo->port().maximum());
  const WorldObject* camera = object(*all, "red1/camera/image");
  ASSERT_NE(camera, nullptr);
  EXPECT_EQ(camera->parent(), "red1/link:head");
  EXPECT_EQ(camera->port().image_stream(), "red1/camera/image");
}

TEST_F(WorldPortsTest, aRobotHasItsTeamAsTheSceneSays) {
  const auto all = worldObjects(simulation());
  const WorldObject* robot = object(*all, "red1");
  ASSERT_NE(robot, nullptr);
  const auto team = std::ranges::find(robot->properties(), "team", &robotcontrol::WorldProperty::name);
  ASSERT_NE(team, robot->properties().end());
  EXPECT_EQ(team->text(), "red");
  const WorldObject* ball = object(*all, "ball");
  ASSERT_NE(ball, nullptr);
  EXPECT_EQ(std::ranges::count(ball->properties(), "team", &robotcontrol::WorldProperty::name), 0);
}

TEST_F(WorldPortsTest, whatAFileSaysIsLocatedThere) {
  const auto all = worldObjects(simulation());
  const WorldObject* ball = object(*all, "ball");
  ASSERT_NE(ball, nullptr);
  EXPECT_TRUE(ball->is_movable());
  const WorldObject* solid = object(*all, "ball/link:ball/solid:ball");
  ASSERT_NE(solid, nullptr);
  const auto friction =
      std::ranges::find(solid->properties(), "friction", &robotcontrol::WorldProperty::name);
  ASSERT_NE(friction, solid->properties().end());
  EXPECT_EQ(friction->values(0), 0.6);
  EXPECT_THAT(friction->file(), HasSubstr("ball"));
  EXPECT_EQ(friction->element(0), "model");
  EXPECT_EQ(friction->element(friction->element_size() - 1), "mu");
}

TEST_F(WorldPortsTest, aPathOfTheTruthThatIsMisspelledIsGuessed) {
  for (const auto& [wrong, meant] : {std::pair("red1/psd/tru", "red1/psd/true"),
                                     std::pair("red1/camera/image/trueth", "red1/camera/image/true"),
                                     std::pair("red1/true_pos", "red1/true_pose")}) {
    robotcontrol::ReadPorts read;
    read.add_ports(wrong);
    const auto done = ports_.read(read);
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().text, HasSubstr(std::string("did you mean '") + meant + "'?"));
  }
}

TEST_F(WorldPortsTest, onlyWhatIsReadIsPublished) {
  EXPECT_TRUE(ports_.isEmpty());
  robotcontrol::ReadPorts read;
  read.add_ports("red1/accelerometer");
  ASSERT_TRUE(ports_.read(read));
  ASSERT_EQ(ports_.readings()->readings_size(), 1);
  EXPECT_EQ(ports_.readings()->readings(0).values_size(), 3);
  read.set_ended(true);
  ASSERT_TRUE(ports_.read(read));
  EXPECT_TRUE(ports_.isEmpty());
}

TEST_F(WorldPortsTest, whatWasReadIsReadAgainOnceItIsBack) {
  robotcontrol::ReadPorts read;
  read.add_ports("red1/accelerometer");
  ASSERT_TRUE(ports_.read(read));
  const TestFolder folder;
  const auto scene = simcore::Scene::load(
      folder.write("empty.sdf", "<sdf version=\"1.9\"><world name=\"empty\"></world></sdf>"));
  ASSERT_TRUE(scene) << robotlink::describe(scene.error());
  const auto without = std::move(SimulatedWorld::create(*scene, {}).value());
  const WorldPorts between(*without, nullptr, &ports_);
  EXPECT_EQ(between.readings()->readings_size(), 0);
  const WorldPorts after(run_->world(), nullptr, &between);
  ASSERT_EQ(after.readings()->readings_size(), 1);
  EXPECT_EQ(after.readings()->readings(0).port(), "red1/accelerometer");
}

TEST_F(WorldPortsTest, ofAnActuatorItIsReadWhatBecameOfItsCommand) {
  robotcontrol::ReadPorts read;
  read.add_ports("red1/headPan/request");
  ASSERT_TRUE(ports_.read(read));
  const auto readings = ports_.readings();
  ASSERT_EQ(readings->readings_size(), 1);
  EXPECT_EQ(readings->readings(0).port(), "red1/headPan/request");
  ASSERT_EQ(readings->readings(0).values_size(), 2);
  EXPECT_EQ(readings->readings(0).values(1), 1) << "nothing is in its way";
  EXPECT_EQ(readings->held_size(), 0);
}

TEST_F(WorldPortsTest, whatCannotBeDoneByHandIsRefused) {
  robotcontrol::Request request;
  request.mutable_drag_object()->set_path("bal");
  request.mutable_drag_object()->set_released(true);
  const auto dropped = changeWorld(run_->world(), request, {});
  ASSERT_FALSE(dropped);
  EXPECT_THAT(dropped.error().text, HasSubstr("there is no 'bal' here; did you mean 'ball'?"));
  request.mutable_drag_object()->set_path("ball");
  EXPECT_TRUE(changeWorld(run_->world(), request, {}));
  request.mutable_throw_model()->set_model("ball");
  request.mutable_throw_model()->mutable_velocity()->set_x(1);
  EXPECT_TRUE(changeWorld(run_->world(), request, {}));
  ASSERT_TRUE(run_->world().simulation().pin("ball", true));
  const auto thrown = changeWorld(run_->world(), request, {});
  ASSERT_FALSE(thrown);
  EXPECT_EQ(thrown.error().text, "'ball' is pinned; release it first");
}

TEST_F(WorldPortsTest, imagesThatARobotSendsAreNotSentTwice) {
  robotcontrol::ReadPorts read;
  read.add_ports("red1/camera/image");
  ASSERT_TRUE(ports_.read(read));
  EXPECT_TRUE(ports_.isEmpty());
  EXPECT_TRUE(ports_.images(true).empty());
}

/// A still cart with eyes of all kinds, before a wall.
const char kEyes[] = R"(<?xml version="1.0"?>
<sdf version="1.9" xmlns:robotcontrol="urn:robotcontrol:sdf"><world name="w">
  <light name="sun" type="directional"><direction>1 0 -1</direction><diffuse>0.5 0.25 1 1</diffuse></light>
  <model name="wall"><static>true</static><pose>2 0 0 0 0 0</pose><link name="l">
    <visual name="v"><geometry><box><size>0.2 8 8</size></box></geometry>
      <material><diffuse>1 0 0 1</diffuse></material></visual></link></model>
  <model name="cart"><link name="base"><gravity>false</gravity>
    <inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>
    <sensor name="depth" type="depth_camera"><update_rate>10</update_rate><robotcontrol:delay>0</robotcontrol:delay>
      <camera><image><width>8</width><height>6</height></image><clip><near>0.1</near><far>5</far></clip></camera></sensor>
    <sensor name="classes" type="segmentation_camera"><camera><image><width>8</width><height>6</height></image></camera></sensor>
    <sensor name="insect" type="custom"><robotcontrol:facette><robotcontrol:azimuth>-0.5 0.5 5</robotcontrol:azimuth>
      <robotcontrol:elevation>0.2 -0.2 3</robotcontrol:elevation></robotcontrol:facette></sensor>
  </link></model>
</world></sdf>)";

TEST(SensorsOfImages, areObjectsAndAreReadAsTheOthers) {
  const TestFolder folder;
  const std::string file = folder / "eyes.sdf";
  std::ofstream(file) << kEyes;
  const auto scene = simcore::Scene::load(file);
  ASSERT_TRUE(scene) << robotlink::describe(scene.error());
  const auto world = std::move(SimulatedWorld::create(*scene, {}).value());
  const auto all = worldObjects(world->simulation());
  std::map<std::string, WorldObject> objects;
  for (const auto& each : all->objects()) objects[each.path()] = each;
  ASSERT_TRUE(objects.contains("cart/depth/depth"));
  const WorldObject& depth = objects["cart/depth/depth"];
  EXPECT_EQ(depth.kind(), WorldObject::SENSOR);
  EXPECT_EQ(depth.parent(), "cart/link:base");
  EXPECT_EQ(depth.port().image_stream(), "cart/depth/depth");
  EXPECT_EQ(depth.port().shape(0), 6);
  EXPECT_EQ(depth.port().maximum(), 5);
  EXPECT_TRUE(std::ranges::any_of(depth.properties(), [](const auto& one) { return one.name() == "delay"; }));
  ASSERT_TRUE(objects.contains("cart/classes/labels") && objects.contains("cart/insect/image"));
  const auto& lamp = objects["light:sun"].properties();
  const auto color = std::ranges::find(lamp, "diffuse", &robotcontrol::WorldProperty::name);
  ASSERT_NE(color, lamp.end());
  EXPECT_EQ(color->values(2), 1);
  EXPECT_EQ(color->element(color->element_size() - 1), "diffuse");

  WorldPorts ports(*world);
  robotcontrol::ReadPorts read;
  for (const char* path : {"cart/depth/depth", "cart/classes/labels", "cart/insect/image"})
    read.add_ports(path);
  ASSERT_TRUE(ports.read(read));
  std::map<std::string, foxglove::RawImage> images;
  for (const auto& message : ports.images(true))
    images[message.path] = dynamic_cast<const foxglove::RawImage&>(*message.value);
  ASSERT_EQ(images.size(), 3U);
  EXPECT_EQ(images["cart/depth/depth"].encoding(), "32FC1");
  float meters = 0;
  std::memcpy(&meters, images["cart/depth/depth"].data().data(), sizeof(meters));
  EXPECT_NEAR(meters, 1.9, 1e-4);
  EXPECT_EQ(images["cart/classes/labels"].encoding(), "rgb8");
  EXPECT_EQ(images["cart/insect/image"].encoding(), "rgb8");
  EXPECT_EQ(images["cart/insect/image"].width(), 5U);
  // Red stays red: other light only changes how bright.
  const auto* pixel = reinterpret_cast<const std::uint8_t*>(images["cart/insect/image"].data().data());
  EXPECT_GT(pixel[0], 50);
  EXPECT_LT(pixel[1], 5);
  const auto readings = ports.readings();
  ASSERT_EQ(readings->readings_size(), 3);
  EXPECT_EQ(readings->readings(2).port(), "cart/insect/image");
  EXPECT_EQ(readings->readings(2).values_size(), 5 * 3 * 3);
}

TEST_F(WorldPortsTest, anUnknownPortIsRefusedByName) {
  robotcontrol::ReadPorts read;
  read.add_ports("red1/acelerometer");
  const auto done = ports_.read(read);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text, HasSubstr("red1/accelerometer"));
  EXPECT_TRUE(ports_.isEmpty());
}

TEST_F(WorldPortsTest, aHeldServoTurnsWhateverTheProgramAsks) {
  ASSERT_TRUE(hold("red1/headPan/request", {0.5}));
  test::play(*run_, 2);
  for (const auto& sensor : simulation().sensors()) {
    if (sensor.info.path == "red1/headPan/position") {
      EXPECT_NEAR(sensor.values[0], 0.5, 0.15);
    }
  }
  ASSERT_EQ(ports_.readings()->held_size(), 1);
  EXPECT_EQ(ports_.readings()->held(0).values(0), 0.5);
}

TEST_F(WorldPortsTest, valuesAreClampedAndReleased) {
  ASSERT_TRUE(hold("red1/headPan/request", {100}));
  const auto held = run_->world().held().all();
  ASSERT_EQ(held.size(), 1U);
  EXPECT_LT(held.begin()->second.values[0], 3.2);
  robotcontrol::SetActuator release;
  release.set_released(true);
  ASSERT_TRUE(ports_.set("red1", release, {}));
  EXPECT_TRUE(ports_.isEmpty());
}

TEST_F(WorldPortsTest, aWrongNumberOfValuesAndAnUnknownActuatorAreRefused) {
  EXPECT_FALSE(hold("red1/headPan/request", {0, 0}));
  EXPECT_FALSE(hold("red1/headPam/request", {0}));
  EXPECT_FALSE(hold("red1/headPan/request", {std::nan("")}));
  EXPECT_TRUE(ports_.isEmpty());
}

TEST_F(WorldPortsTest, nothingIsHeldWhileARobotMustNotMove) {
  ASSERT_TRUE(hold("red1/headPan/request", {0.2}));
  stopped_ = {"red1"};
  ports_.release(stopped_);
  EXPECT_FALSE(ports_.holdsAny());
  EXPECT_FALSE(hold("red1/headPan/request", {0.2}));
}

TEST_F(WorldPortsTest, aResetReleasesAll) {
  ASSERT_TRUE(hold("red1/headPan/request", {0.2}));
  run_->world().reset(1);
  EXPECT_FALSE(ports_.holdsAny());
}

TEST_F(WorldPortsTest, errorsOfASensorThatARequestDoesNotNameStay) {
  const auto after = [this](const auto& set) {
    robotcontrol::Request request;
    auto& errors = *request.mutable_set_sensor_errors();
    errors.set_sensor("red1/psd");
    set(errors);
    EXPECT_TRUE(changeWorld(run_->world(), request, {}));
    return simulation().errorsInUse("red1/psd");
  };
  auto expected = simulation().errorsInUse("red1/psd");
  if (expected.noise.empty()) expected.noise.emplace_back();
  expected.delay = 0.1;
  expected.noise[0].precision = 0.01;
  EXPECT_EQ(after([](auto& errors) {
              errors.set_delay(0.1);
              errors.set_precision(0.01);
            }),
            expected);
  expected.noise[0].driftStddev = 0.2;
  expected.noise[0].driftTime = simcore::NoiseModel::kForever;
  EXPECT_EQ(after([](auto& errors) { errors.set_drift(0.2); }), expected);
  expected.delay = 0;
  EXPECT_EQ(after([](auto& errors) { errors.set_delay(0); }), expected) << "0 can be named, too";
  EXPECT_EQ(after([](auto&) {}), simcore::SensorErrors()) << "nothing named: it measures what is true";
}

TEST_F(WorldPortsTest, whatTheOracleKnowsIsRead) {
  robotcontrol::ReadPorts read;
  for (const char* port : {"red1/true_pose", "red1/headPan/position/true", "red1/camera/image/true"})
    read.add_ports(port);
  ASSERT_TRUE(ports_.read(read));
  const auto readings = ports_.readings();
  ASSERT_EQ(readings->readings_size(), 3);
  const auto& camera = readings->readings(0);
  EXPECT_EQ(camera.port(), "red1/camera/image/true");
  ASSERT_GT(camera.percepts_size(), 0);
  EXPECT_EQ(camera.percepts(0).model(), "field");
  EXPECT_GT(camera.percepts(0).pixels(), 100);
  EXPECT_TRUE(camera.percepts(0).has_model_in_camera());
  EXPECT_EQ(readings->readings(1).values_size(), 1);
  EXPECT_EQ(readings->readings(2).values_size(), 7);
  for (const char* port : {"red1/headPan/request/true", "red1/nose/true", "red1/true_pose/true"}) {
    read.clear_ports();
    read.add_ports(port);
    EXPECT_FALSE(ports_.read(read)) << port;
  }
}

}  // namespace
}  // namespace app
