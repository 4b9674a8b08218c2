// SPDX-License-Identifier: GPL-3.0-or-later
// A scene with controllers in the workbench: what they show, keys for them, and remote controllers.
#include <gmock/gmock.h>
#include <unistd.h>

#include "app/core/Workbench.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Resources.h"
#include "tests/app/TickUntil.h"

namespace app {
namespace {

using robotcontrol::Request;
using robotcontrol::WorldObject;

class ControlledSceneTest : public testing::Test {
 protected:
  ControlledSceneTest()
      : workbench_(std::filesystem::path(testing::TempDir()) / ("controlled-" + std::to_string(::getpid()))) {
    workbench_.onErrors([this](const robotlink::Errors& errors) { errors_ = errors; });
    RunOptions options = defaultSimulation();
    options.scene = robotlink::resource("scenes/elevator.sdf");
    workbench_.open(SimulationFeed::opening(options));
    EXPECT_TRUE(waitFor([this] {
      return workbench_.loaded() != nullptr && latest<robotcontrol::WorldObjects>("objects") != nullptr;
    })) << robotlink::describe(errors_);
  }

  template <typename Condition>
  bool waitFor(Condition condition) {
    return app::test::tickUntil(workbench_, condition);
  }
  template <typename Message>
  const Message* latest(const std::string& path) {
    return workbench_.session().store().latestAs<Message>(path, workbench_.session().timeline().newest());
  }
  const WorldObject* object(const std::string& path) {
    for (const auto& each : latest<robotcontrol::WorldObjects>("objects")->objects())
      if (each.path() == path) return &each;
    return nullptr;
  }
  void run(const char* line) {
    const auto done = workbench_.commands().runLine(line);
    EXPECT_TRUE(done.has_value()) << line << ": " << (done ? "" : done.error().describe());
  }
  void read(const std::vector<std::string>& ports) {
    Request request;
    for (const std::string& port : ports) request.mutable_read_ports()->add_ports(port);
    workbench_.session().request(request);
  }
  double reading(const std::string& port) {
    const auto* readings = latest<robotcontrol::PortReadings>("ports");
    if (readings == nullptr) return -1;
    for (const auto& each : readings->readings())
      if (each.port() == port) return each.values(0);
    return -1;
  }

  Workbench workbench_;
  robotlink::Errors errors_;
};

TEST_F(ControlledSceneTest, controllersAndWhatTheyShowAreObjectsOfTheScene) {
  const WorldObject* controller = object("elevator/controller:elevator");
  ASSERT_NE(controller, nullptr);
  EXPECT_EQ(controller->kind(), WorldObject::CONTROLLER);
  EXPECT_EQ(controller->parent(), "elevator");
  const WorldObject* floor = object("elevator/elevator/floor");
  ASSERT_NE(floor, nullptr);
  EXPECT_EQ(floor->parent(), "elevator/controller:elevator");
  EXPECT_EQ(object("elevator/elevator/panel")->port().image_stream(), "elevator/elevator/panel");
  EXPECT_EQ(object("ball_replacer/count")->parent(), "controller:ball_replacer");
  const auto* states = latest<robotcontrol::ControllerStates>("controllers");
  ASSERT_NE(states, nullptr);
  EXPECT_EQ(states->controllers_size(), 2);
  EXPECT_TRUE(states->controllers(0).is_on());
}

TEST_F(ControlledSceneTest, keysReachThemAndTheirValuesImagesAndDrawingsArePublished) {
  read({"elevator/elevator/floor", "elevator/elevator/calls", "elevator/elevator/panel"});
  run("simulation.key 2");
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return latest<robotcontrol::ViewEvents>("events") != nullptr; }));
  EXPECT_EQ(latest<robotcontrol::ViewEvents>("events")->events_size(), 2);
  const auto* panel = latest<foxglove::RawImage>("elevator/elevator/panel");
  ASSERT_NE(panel, nullptr);
  EXPECT_EQ(panel->height(), 36U);
  const auto* sign = latest<foxglove::SceneUpdate>("elevator/elevator/sign");
  ASSERT_NE(sign, nullptr);
  EXPECT_EQ(sign->entities(0).texts_size(), 1);
  run("simulation.speed 0");
  run("simulation.start");
  EXPECT_TRUE(waitFor([this] { return reading("elevator/elevator/floor") == 1; }));
  EXPECT_TRUE(errors_.empty()) << robotlink::describe(errors_);
}

TEST_F(ControlledSceneTest, aControllerElsewhereInLockstepHasEachStepWaitForItsAnswer) {
  Request attach;
  auto& wish = *attach.mutable_attach_controller();
  wish.set_name("remote");
  wish.add_sensors("elevator/rail/position");
  wish.add_sensors("elevator/rail/request");
  wish.set_lockstep(true);
  wish.set_patience(60);
  workbench_.session().request(attach);
  const auto inputs = [this] { return latest<robotcontrol::ControllerInputs>("sim/ports/remote"); };
  ASSERT_TRUE(waitFor([&] { return inputs() != nullptr; }));
  EXPECT_EQ(inputs()->step(), 0U);
  EXPECT_NE(object("controller:remote"), nullptr);
  run("simulation.speed 0");
  run("simulation.start");
  for (std::uint64_t step = 0; step < 20; step += 2) {
    ASSERT_TRUE(waitFor([&] { return inputs()->step() == step; })) << step;
    Request answer;
    auto& set = *answer.mutable_set_ports();
    set.set_controller("remote");
    set.set_step(step);
    auto& command = *set.add_commands();
    command.set_port("elevator/rail/request");
    command.add_values(0.3);
    workbench_.session().request(answer);
  }
  ASSERT_TRUE(waitFor([&] { return inputs()->step() == 20; }));
  EXPECT_GT(inputs()->readings(0).values(0), 0.01) << "it moves";
  ASSERT_EQ(inputs()->readings_size(), 2);
  EXPECT_EQ(inputs()->readings(1).values_size(), 2) << "whether it is there, and nothing was in the way";
  attach.mutable_attach_controller()->set_ended(true);
  workbench_.session().request(attach);
  EXPECT_TRUE(waitFor([this] { return object("controller:remote") == nullptr; }));
}

TEST_F(ControlledSceneTest, whoDoesNotAnswerIsNamedAndTheSimulationGoesOn) {
  Request attach;
  auto& wish = *attach.mutable_attach_controller();
  wish.set_name("sleeper");
  wish.set_lockstep(true);
  wish.set_patience(0.001);
  workbench_.session().request(attach);
  run("simulation.start");
  const auto state = [this]() -> const robotcontrol::ControllerState* {
    const auto* states = latest<robotcontrol::ControllerStates>("controllers");
    if (states == nullptr || states->controllers_size() < 3) return nullptr;
    return &states->controllers(2);
  };
  ASSERT_TRUE(waitFor([&] { return state() != nullptr && state()->late() == 1; }));
  EXPECT_EQ(state()->path(), "sleeper");
  EXPECT_FALSE(state()->is_on());
  const auto steps = [this] {
    const auto* status = latest<robotcontrol::SimulationStatus>("simulation");
    return status != nullptr ? status->steps() : 0;
  };
  EXPECT_TRUE(waitFor([&] { return steps() > 20; }));
}

}  // namespace
}  // namespace app
