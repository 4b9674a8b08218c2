// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/WireSetups.h"

#include <gmock/gmock.h>

#include "app/core/own/OwnProgramOptions.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/app/program/FakeProgram.h"

namespace app {
namespace {

using robotlink::Layout;
using testing::ElementsAre;

Layout made() {
  Layout layout;
  layout.name = "two";
  layout.help = "Two processes.";
  layout.file = "two.yaml";
  Layout::Process see;
  see.name = "see";
  see.priority = -5;
  see.period = std::chrono::milliseconds(8);
  see.tasks = {{"ball-percept", "region", {"two.yaml", 3, 1}}, {"behavior", "go", {}}};
  see.tasks[0].choose("scan");
  see.blocking = {{"camera/image", {}, false}, {"joints/states", {}, true}};
  see.blockingOutputs = {{"percepts/ball", {}, false}};
  Layout::Process debug;
  debug.name = "debug";
  debug.debug = true;
  layout.processes = {see, debug};
  layout.absent = {{"see", "walk", "nobody offers joints/states"}};
  layout.withheld = {"ball/model"};
  return layout;
}

class WireSetupsTest : public testing::Test {
 protected:
  robotcontrol::WireSetup setup(const OwnProgramOptions& options) {
    clock_.set(robotlink::Instant(std::chrono::seconds(3)));
    robotlink::ParameterSource parameters;
    parameters.recorded.emplace_back().set_task("behavior");
    return wireSetup(
        {.robot = robot_, .platform = platform_, .file = file_, .layout = made(), .parameters = parameters},
        options);
  }

  robotlink::ManualClock clock_;
  test::FakePlatform platform_{clock_};
  const HostedRobot robot_ = test::fakeRobot();
  const std::filesystem::path file_ = "/layouts/two.yaml";
};

TEST_F(WireSetupsTest, aRobotOfFilesIsNamedByThem) {
  OwnProgramOptions options;
  options.memoryLimit = 1U << 20U;
  options.threads = true;
  options.inRealTime = true;
  options.patience = std::chrono::milliseconds(1500);
  const auto wire = setup(options);
  EXPECT_EQ(wire.robot(), "red1");
  EXPECT_EQ(wire.team(), "red");
  EXPECT_EQ(wire.kind(), robot_.description->name);
  EXPECT_EQ(wire.layout_file(), "/layouts/two.yaml");
  EXPECT_EQ(wire.time(), 3'000'000'000);
  EXPECT_EQ(wire.memory_limit(), 1U << 20U);
  EXPECT_TRUE(wire.threads());
  EXPECT_TRUE(wire.real_time());
  EXPECT_EQ(wire.patience(), 1.5);
  EXPECT_FALSE(wire.has_layout()) << "it is read from its file";
  ASSERT_EQ(wire.parameters_size(), 1);
  EXPECT_EQ(wire.parameters(0).task(), "behavior");
}

TEST_F(WireSetupsTest, onlySolutionsThatTheLayoutDoesNotNameAreSent) {
  const auto wire = setup({});
  ASSERT_EQ(wire.solutions_size(), 1);
  EXPECT_EQ(wire.solutions(0).task(), "ball-percept");
  EXPECT_EQ(wire.solutions(0).solution(), "scan");
}

TEST_F(WireSetupsTest, theLayoutOfARobotWithoutFilesSurvives) {
  OwnProgramOptions options;
  options.texts = std::make_shared<robotcontrol::ProgramSetup>();
  options.order = {"see", "debug"};
  const auto wire = setup(options);
  EXPECT_THAT(wire.order(), ElementsAre("see", "debug"));
  const Layout layout = layoutIn(wire.layout());
  EXPECT_EQ(layout.name, "two");
  EXPECT_EQ(layout.help, "Two processes.");
  EXPECT_EQ(layout.file, "two.yaml");
  ASSERT_EQ(layout.processes.size(), 2U);
  const Layout::Process& see = layout.processes[0];
  EXPECT_EQ(see.name, "see");
  EXPECT_EQ(see.priority, -5);
  EXPECT_EQ(see.period, std::chrono::milliseconds(8));
  EXPECT_FALSE(see.debug);
  ASSERT_EQ(see.tasks.size(), 2U);
  EXPECT_EQ(see.tasks[0].task, "ball-percept");
  EXPECT_EQ(see.tasks[0].solution, "scan");
  EXPECT_EQ(see.tasks[0].ownSolution, "region");
  EXPECT_EQ(see.tasks[1].ownSolution, "");
  ASSERT_EQ(see.blocking.size(), 2U);
  EXPECT_EQ(see.blocking[0].package, "camera/image");
  EXPECT_FALSE(see.blocking[0].paceOnly);
  EXPECT_TRUE(see.blocking[1].paceOnly);
  ASSERT_EQ(see.blockingOutputs.size(), 1U);
  EXPECT_EQ(see.blockingOutputs[0].package, "percepts/ball");
  EXPECT_TRUE(layout.processes[1].debug);
  ASSERT_EQ(layout.absent.size(), 1U);
  EXPECT_EQ(layout.absent[0].task, "walk");
  EXPECT_EQ(layout.absent[0].reason, "nobody offers joints/states");
  EXPECT_THAT(layout.withheld, ElementsAre("ball/model"));
}

}  // namespace
}  // namespace app
