// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/adapter/SceneCommands.h"

#include <gmock/gmock.h>

#include <numbers>

#include "robotcontrol/World.pb.h"
#include "tests/app/open/AskedWorkbench.h"

namespace app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A workbench whose requests are seen, with what a simulation publishes of its scene.
class SceneCommandsTest : public testing::Test {
 protected:
  void publishStatus(bool isReal = false) {
    robotcontrol::SimulationStatus status;
    status.add_models("ball");
    status.add_models("red1");
    status.set_is_real(isReal);
    desk_.publish("simulation", status);
    desk_.workbench.session().setRobots({"red1"});
  }
  void publishObjects() {
    robotcontrol::WorldObjects all;
    const auto add = [&all](const std::string& path, const std::string& model) {
      auto& object = *all.add_objects();
      object.set_path(path);
      object.set_model(model);
      return &object;
    };
    add("red1", "red1");
    add("crane", "crane");
    const auto addPort = [&](const std::string& path, const std::string& model, bool isActuator) {
      auto& port = *add(path, model)->mutable_port();
      port.set_path(path);
      port.set_is_actuator(isActuator);
      return &port;
    };
    addPort("red1/headPan/request", "red1", true);
    addPort("red1/wheels", "red1", true)->add_shape(2);
    addPort("red1/headPan/position", "red1", false);
    addPort("crane/hook", "crane", true);
    addPort("drone/motion", "drone", true)->add_shape(6);
    desk_.publish("objects", all);
  }
  std::string run(const std::string& line) { return desk_.run(line); }
  std::vector<std::string> offered(const std::string& command, const std::vector<std::string>& before = {}) {
    return desk_.offered(command, before);
  }

  test::AskedWorkbench desk_;
};

TEST_F(SceneCommandsTest, withoutASimulationEachCommandSaysWhatIsMissing) {
  for (const char* line : {"scene.place ball 1 2", "scene.turn ball 1", "scene.throw ball 1 0",
                           "scene.pin ball", "scene.drag ball 1 0 1", "scene.drop", "scene.push ball 1 0"}) {
    EXPECT_THAT(run(line), testing::StartsWith("scene.none: there is no simulation in which something could"))
        << line;
  }
  for (const char* line :
       {"scene.add burger 1 1", "scene.remove red1", "scene.duplicate red1", "scene.undo", "scene.reload"}) {
    EXPECT_EQ(run(line), "simulation.none: there is no simulation; open a scene first") << line;
  }
  EXPECT_THAT(desk_.asked, IsEmpty());
  for (const char* command : {"scene.place", "scene.turn", "scene.hold", "scene.add", "scene.remove"})
    EXPECT_THAT(offered(command), IsEmpty()) << command;
}

TEST_F(SceneCommandsTest, aRealRobotIsNotMovedByHand) {
  publishStatus(true);
  EXPECT_THAT(run("scene.throw ball 1 0"), testing::StartsWith("scene.none: "));
  EXPECT_THAT(run("scene.pin red1"), testing::StartsWith("scene.none: "));
}

TEST_F(SceneCommandsTest, aModelIsPlacedWithItsHeadingInOneTurn) {
  publishStatus();
  EXPECT_EQ(run("scene.place ball -0.5 0.25"),
            "place_model { model: \"ball\" pose_in_field { x: -0.5 y: 0.25 } }");
  EXPECT_EQ(run("scene.place red1 0 0 --height 0.5 --roll 1 --pitch 0.25"),
            "place_model { model: \"red1\" pose_in_field { } height: 0.5 roll: 1 pitch: 0.25 }");
  run("scene.place red1 0 0 7");
  EXPECT_NEAR(desk_.asked.front().place_model().pose_in_field().heading(), 7 - 2 * std::numbers::pi, 1e-12);
}

TEST_F(SceneCommandsTest, whatCannotBePlacedIsRefusedWithWhatCan) {
  publishStatus();
  EXPECT_EQ(run("scene.place goal 0 0"),
            "scene.model: there is no model goal that can be placed; there are ball, red1");
  publishObjects();
  EXPECT_EQ(run("scene.place crane 0 0"),
            "scene.model: 'crane' is fixed to the world; change its <pose> in the scene's file instead");
  EXPECT_THAT(offered("scene.place"), ElementsAre("ball", "red1"));
  EXPECT_THAT(offered("scene.place", {"ball"}), IsEmpty()) << "numbers are not offered";
}

TEST_F(SceneCommandsTest, anActuatorIsHeldAtAsManyValuesAsItHas) {
  publishStatus();
  publishObjects();
  EXPECT_EQ(run("scene.hold red1/headPan/request 0.25 7"),
            "robot: \"red1\" set_actuator { port: \"red1/headPan/request\" values: 0.25 }");
  EXPECT_EQ(run("scene.hold red1/wheels 0.5 --second -0.5"),
            "robot: \"red1\" set_actuator { port: \"red1/wheels\" values: 0.5 values: -0.5 }");
  EXPECT_EQ(
      run("scene.hold drone/motion 1 2 3 4 5 6"),
      "set_actuator { port: \"drone/motion\" values: 1 values: 2 values: 3 values: 4 values: 5 values: 6 }");
  EXPECT_EQ(
      run("scene.hold drone/motion 1"),
      "set_actuator { port: \"drone/motion\" values: 1 values: 0 values: 0 values: 0 values: 0 values: 0 }");
  EXPECT_EQ(run("scene.hold crane/hook 1"), "set_actuator { port: \"crane/hook\" values: 1 }")
      << "one of the world, not of a robot";
}

TEST_F(SceneCommandsTest, onlyActuatorsAreHeld) {
  publishStatus();
  publishObjects();
  EXPECT_EQ(run("scene.hold red1/headPam/request 1"),
            "scene.actuator: there is no actuator red1/headPam/request; did you mean "
            "'red1/headPan/request'?");
  EXPECT_EQ(run("scene.release red1/headPan/position"),
            "scene.actuator: there is no actuator red1/headPan/position; there are red1/headPan/request, "
            "red1/wheels, crane/hook, drone/motion");
  EXPECT_THAT(offered("scene.hold"),
              ElementsAre("red1/headPan/request", "red1/wheels", "crane/hook", "drone/motion"));
}

TEST_F(SceneCommandsTest, oneActuatorIsReleasedOrAllAre) {
  publishStatus();
  publishObjects();
  EXPECT_EQ(run("scene.release red1/wheels"),
            "robot: \"red1\" set_actuator { port: \"red1/wheels\" released: true }");
  EXPECT_EQ(run("scene.release"), "set_actuator { released: true }");
}

TEST_F(SceneCommandsTest, whatIsDoneByHandIsAskedForWithAllItsNumbers) {
  publishStatus();
  EXPECT_EQ(run("scene.turn ball 1 2 3"), "turn_model { model: \"ball\" heading: 1 roll: 2 pitch: 3 }");
  EXPECT_EQ(run("scene.throw ball 1 2 3 4"),
            "throw_model { model: \"ball\" velocity { x: 1 y: 2 z: 3 } spin { z: 4 } }");
  EXPECT_EQ(run("scene.pin red1/link:body"), "pin_object { path: \"red1/link:body\" pinned: true }");
  EXPECT_EQ(run("scene.pin red1 off"), "pin_object { path: \"red1\" }");
  EXPECT_EQ(run("scene.drag ball 1 2 3 0.5"),
            "drag_object { path: \"ball\" target { x: 1 y: 2 z: 3 } strength: 0.5 }");
  EXPECT_EQ(run("scene.drop"), "drag_object { released: true }");
  EXPECT_EQ(run("scene.drop ball"), "drag_object { path: \"ball\" released: true }");
  EXPECT_EQ(run("scene.push ball 1 2 3 0.5"),
            "push_object { path: \"ball\" force { x: 1 y: 2 z: 3 } seconds: 0.5 }");
}

TEST_F(SceneCommandsTest, whatMakesNoSenseByHandIsRefusedBeforeItIsAsked) {
  publishStatus();
  EXPECT_EQ(run("scene.throw ball 1000 0"), "scene.hand: a model can be thrown with at most 100 m/s");
  EXPECT_EQ(run("scene.drag ball 0 0 1 1000"),
            "scene.hand: the strength of dragging must be between 0.01 and 100 times the usual one");
  EXPECT_EQ(run("scene.push ball 1 0 0 61"), "scene.hand: an object can be pushed for at most 60 s");
  EXPECT_EQ(run("scene.turn '' 1"), "scene.hand: the request must name the model to turn");
  EXPECT_THAT(desk_.asked, IsEmpty());
}

TEST_F(SceneCommandsTest, aModelIsAddedOnTheFloorUnlessAHeightIsGiven) {
  ASSERT_TRUE(desk_.openSimulation());
  EXPECT_EQ(run("scene.add burger 1 2"),
            "edit_scene { add { model: \"burger\" pose_in_field { x: 1 y: 2 } } }");
  EXPECT_EQ(run("scene.add burger 1 2 --name turtle --height 0 --team red"),
            "edit_scene { add { model: \"burger\" name: \"turtle\" pose_in_field { x: 1 y: 2 } height: 0 "
            "team: \"red\" } }");
  for (const char* height : {"high", "1m", "nan", "inf", "1 2"}) {
    EXPECT_EQ(run("scene.add burger 1 2 --height '" + std::string(height) + "'"),
              "scene.height: the height must be a number of meters, not '" + std::string(height) + "'");
  }
}

TEST_F(SceneCommandsTest, theSceneIsChangedByNames) {
  ASSERT_TRUE(desk_.openSimulation());
  EXPECT_EQ(run("scene.remove red1"), "edit_scene { remove { model: \"red1\" } }");
  EXPECT_EQ(run("scene.duplicate red1 --name red2"),
            "edit_scene { duplicate { model: \"red1\" name: \"red2\" } }");
  EXPECT_EQ(run("scene.undo"), "edit_scene { undo: true }");
  EXPECT_EQ(run("scene.remove ''"), "scene.edit: the request must name the model to remove");
  publishObjects();
  EXPECT_THAT(offered("scene.remove"), ElementsAre("red1", "crane")) << "models, not what is in them";
}

}  // namespace
}  // namespace app
