// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped scene with robots of different kinds, each with its own platform, program, layout and field.
#include <gmock/gmock.h>

#include <map>

#include "app/core/program/ShippedFiles.h"
#include "robotlink/config/FieldDescription.h"
#include "tests/TestFolder.h"
#include "tests/app/SimulatedRuns.h"

using namespace app;
using testing::UnorderedElementsAre;

namespace {

RunOptions mixedScene() {
  RunOptions options = test::simulationOptions();
  options.scene = sceneNamed("mixed");
  return options;
}

robotlink::Vector3 placeOf(const SimulatedRun& run, const std::string& robot) {
  return run.world().simulation().modelPose(robot)->translation();
}

std::uint64_t digestOfMixed(double seconds) {
  const auto run = test::makeRun(mixedScene());
  if (!run) return 0;
  test::play(*run, seconds);
  return run->world().digest();
}

}  // namespace

TEST(MixedScene, theProgramsOfAllKindsRunAndTheRobotsMove) {
  std::string troubles;
  std::map<std::string, int> queues;
  const auto run = test::makeRun(
      mixedScene(), {[&](const std::string& robot, const auto&) { ++queues[robot]; },
                     [&](const std::string&, const auto&, const std::string& text) { troubles += text; }});
  ASSERT_NE(run, nullptr);
  ASSERT_THAT(run->robots(), UnorderedElementsAre("red1", "p3at1", "burger1"));
  std::map<std::string, robotlink::Vector3> starts;
  for (const std::string& robot : run->robots()) starts[robot] = placeOf(*run, robot);
  test::play(*run, 6);
  for (const std::string& robot : run->robots()) {
    EXPECT_GT(queues[robot], 50) << robot;
    EXPECT_GT((placeOf(*run, robot) - starts[robot]).head<2>().norm(), 0.05) << robot;
  }
  EXPECT_EQ(troubles, "");
}

TEST(MixedScene, eachRobotHasItsKindAndTheLayoutThatTheSceneOrItsDescriptionNames) {
  const auto run = test::makeRun(mixedScene());
  ASSERT_NE(run, nullptr);
  EXPECT_EQ(run->description("red1")->name, "ers210");
  EXPECT_EQ(run->description("p3at1")->name, "p3at");
  EXPECT_EQ(run->description("burger1")->name, "burger");
  EXPECT_EQ(run->layout().stem(), "compact");
  EXPECT_EQ(run->otherLayouts().at("p3at1").stem(), "pioneer-wander");
  EXPECT_EQ(run->field()->name, "Four-legged league 2002") << "that of the robot that plays soccer";
}

TEST(MixedScene, aLayoutCanBeChosenForOneRobotAndForThoseThatCanRunIt) {
  RunOptions options = mixedScene();
  options.robotLayouts["burger1"] = layoutNamed("pioneer");
  options.layout = layoutNamed("parallel");
  const auto run = test::makeRun(options);
  ASSERT_NE(run, nullptr);
  EXPECT_EQ(run->layout().stem(), "parallel");
  EXPECT_EQ(run->otherLayouts().at("p3at1").stem(), "pioneer-wander");
  EXPECT_EQ(run->otherLayouts().at("burger1").stem(), "pioneer");
}

TEST(MixedScene, itIsTheSameInEachRun) {
  const std::uint64_t first = digestOfMixed(1);
  EXPECT_EQ(digestOfMixed(1), first);
}

namespace {

/// Why a scene with one robot, a burger in the line 3, cannot be run.
std::string whyNotWith(const std::string& inWorld, const std::string& inRobot, RunOptions options) {
  const TestFolder folder;
  options.scene = folder.write(
      "world.sdf",
      "<sdf version='1.9' xmlns:robotcontrol='urn:robotcontrol:sdf'><world name='w'>" + inWorld +
          "\n<include><uri>model://ground_plane</uri></include>\n<include><uri>model://burger</uri>" +
          inRobot + "<pose>0 0 0.01 0 0 0</pose></include></world></sdf>");
  const auto run = SimulatedRun::create(options, {});
  const std::string text = run ? "" : robotlink::describe(run.error());
  return text.starts_with(folder.path().string()) ? text.substr(folder.path().string().size()) : text;
}

}  // namespace

TEST(SceneNames, aLayoutThatIsMissingIsSaidWithTheLineOfTheRobot) {
  EXPECT_EQ(whyNotWith("", "", test::simulationOptions()), "");
  const std::string named = "<robotcontrol:layout>pioneer-wonder</robotcontrol:layout>";
  EXPECT_EQ(whyNotWith("", named, test::simulationOptions()),
            "/world.sdf:3: 'burger' has a layout 'pioneer-wonder' that is neither a shipped one nor a file; "
            "correct its <robotcontrol:layout>");
  RunOptions options = test::simulationOptions();
  options.robotLayouts["burger"] = layoutNamed("pioneer");
  EXPECT_EQ(whyNotWith("", named, options), "") << "another one was chosen";
}

TEST(SceneNames, aGameWithoutRulesIsSaidWithTheScene) {
  EXPECT_THAT(
      whyNotWith("<robotcontrol:game>2002x</robotcontrol:game>", "", test::simulationOptions()),
      testing::StartsWith(
          "/world.sdf:1: w: the <robotcontrol:game> is '2002x', but there are no rules of that name ("));
}

TEST(SceneNames, aRobotWithoutADescriptionIsSaidWithItsLine) {
  const TestFolder folder;
  RunOptions options = test::simulationOptions();
  options.scene =
      folder.write("world.sdf",
                   "<sdf version='1.9' xmlns:robotcontrol='urn:robotcontrol:sdf'><world name='w'>\n"
                   "<model name='x1'><robotcontrol:robot>nobody</robotcontrol:robot>"
                   "<link name='l'/></model></world></sdf>");
  const auto run = SimulatedRun::create(options, {});
  ASSERT_FALSE(run);
  EXPECT_THAT(robotlink::describe(run.error()),
              testing::HasSubstr("world.sdf:2: 'x1' is a robot 'nobody', of which there is no description "));
}
