// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/world/WorldPorts.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/core/world/WorldObjects.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "simcore/Scene.h"
#include "simcore/world/WorldDescription.h"
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

TEST_F(WorldPortsTest, imagesThatARobotSendsAreNotSentTwice) {
  robotcontrol::ReadPorts read;
  read.add_ports("red1/camera/image");
  ASSERT_TRUE(ports_.read(read));
  EXPECT_TRUE(ports_.isEmpty());
  EXPECT_TRUE(ports_.images(true).empty());
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

}  // namespace
}  // namespace app
