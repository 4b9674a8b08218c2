// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/RobotProgram.h"

using namespace robotlink;

namespace {

const std::filesystem::path kResources = ROBOTCONTROL_SOURCE_DIR "/resources";

/// The shipped layouts on the platforms of the ERS-210.
class ShippedLayoutsTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    auto robot = readRobotDescription(kResources / "robots/ers210.yaml");
    ASSERT_TRUE(robot) << describe(robot.error());
    robot_ = *robot;
    auto layout = readLayout(kResources / "layouts" / (std::string(GetParam()) + ".yaml"));
    ASSERT_TRUE(layout) << describe(layout.error());
    layout_ = *layout;
  }
  PlatformPackages platform(bool simulated) const {
    PlatformPackages packages{robot_.offers, robot_.takes, debugPackages()};
    if (simulated) return packages;
    std::erase_if(packages.offers, [this](const std::string& package) {
      return std::find(robot_.simulatedOnly.begin(), robot_.simulatedOnly.end(), package) !=
             robot_.simulatedOnly.end();
    });
    return packages;
  }

  RobotDescription robot_;
  Layout layout_;
};

TEST_P(ShippedLayoutsTest, itSuitsTheRegisteredSolutionsWithAndWithoutASimulator) {
  EXPECT_EQ(GetParam(), layout_.name);
  EXPECT_EQ("", describe(checkLayout(layout_, registeredTasks(), platform(true))));
  EXPECT_EQ("", describe(checkLayout(layout_, registeredTasks(), platform(false))));
}

TEST_P(ShippedLayoutsTest, everyRegisteredTaskIsDone) {
  for (const auto& [name, task] : registeredTasks().tasks) {
    const bool done = std::any_of(
        layout_.processes.begin(), layout_.processes.end(), [&, &wanted = name](const auto& process) {
          return std::any_of(process.tasks.begin(), process.tasks.end(),
                             [&](const auto& entry) { return entry.task == wanted; });
        });
    EXPECT_TRUE(done) << name;
  }
}

TEST_P(ShippedLayoutsTest, everySolutionCanBeChosenInASimulator) {
  const TaskCatalog catalog = registeredTasks();
  for (const auto& [name, task] : catalog.tasks) {
    EXPECT_GE(task.solutions.size(), 2U) << name << " has only one way to be done";
    for (const auto& solution : task.solutions) {
      EXPECT_EQ("", unavailability(layout_, catalog, platform(true), name, solution.name))
          << name << " " << solution.name;
    }
  }
}

TEST_P(ShippedLayoutsTest, withoutASimulatorOraclesSayWhyTheyCannotBeChosen) {
  EXPECT_EQ("unavailable because nobody offers oracle/world",
            unavailability(layout_, registeredTasks(), platform(false), "ball-model", "oracle"));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLayoutsTest, testing::Values("parallel", "compact", "balanced"),
                         [](const auto& layout) { return std::string(layout.param); });

}  // namespace
