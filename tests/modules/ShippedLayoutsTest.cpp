// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/program/RobotProgram.h"

using namespace robotlink;

namespace {

const std::filesystem::path kShipped = ROBOTCONTROL_SOURCE_DIR "/resources";

/// A shipped layout and the kind of robot that it is for.
struct Shipped {
  const char* layout;
  const char* robot;
};

/// The shipped layouts on the platforms of their robots.
class ShippedLayoutsTest : public testing::TestWithParam<Shipped> {
 protected:
  void SetUp() override {
    auto robot = readRobotDescription(kShipped / "robots" / (std::string(GetParam().robot) + ".yaml"));
    ASSERT_TRUE(robot) << describe(robot.error());
    robot_ = *robot;
    auto layout = readLayout(kShipped / "layouts" / (std::string(GetParam().layout) + ".yaml"));
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
  bool does(const std::string& task) const {
    return std::ranges::any_of(layout_.processes, [&](const auto& process) {
      return std::ranges::any_of(process.tasks, [&](const auto& entry) { return entry.task == task; });
    });
  }
  /// The packages that neither the platform nor any task of the layout offers.
  bool isOffered(const std::string& package, const TaskCatalog& catalog) const {
    const PlatformPackages all = platform(true);
    if (std::ranges::count(all.offers, package) + std::ranges::count(all.debugOffers, package) > 0)
      return true;
    return std::ranges::any_of(catalog.tasks, [&](const auto& entry) {
      return does(entry.first) && std::ranges::any_of(entry.second.solutions, [&](const auto& solution) {
               return std::ranges::count(solution.outputs, package) > 0;
             });
    });
  }

  RobotDescription robot_;
  Layout layout_;
};

TEST_P(ShippedLayoutsTest, itSuitsTheRegisteredSolutionsWithAndWithoutASimulator) {
  EXPECT_EQ(GetParam().layout, layout_.name);
  EXPECT_EQ("", describe(checkLayout(layout_, registeredTasks(), platform(true))));
  EXPECT_EQ("", describe(checkLayout(layout_, registeredTasks(), platform(false))));
}

TEST_P(ShippedLayoutsTest, itDoesAllThatItsKindOfRobotCan) {
  // What a robot on legs does, and what one on wheels does: each task that yields what its platform takes,
  // and all that those need.
  const bool wheels = robot_.drive.has_value();
  for (const auto& [name, task] : registeredTasks().tasks) {
    const bool ofWheels = name == "path-planning" || name == "driving" || name == "obstacle-avoidance";
    // A program that makes a map also finds its place in it.
    const bool maps = does("mapping");
    const bool expected = name == "self-localisation" ? !maps : name == "mapping" ? maps : ofWheels == wheels;
    EXPECT_EQ(expected, does(name)) << name;
  }
}

TEST_P(ShippedLayoutsTest, everySolutionForItsKindOfRobotCanBeChosenInASimulator) {
  const TaskCatalog catalog = registeredTasks();
  for (const auto& [name, task] : catalog.tasks) {
    if (!does(name)) continue;
    int choosable = 0;
    for (const auto& solution : task.solutions) {
      const std::string why = unavailability(layout_, catalog, platform(true), name, solution.name);
      const bool forThisRobot = std::ranges::all_of(
          solution.required, [&](const std::string& package) { return isOffered(package, catalog); });
      EXPECT_EQ(forThisRobot, why.empty()) << name << " " << solution.name << ": " << why;
      choosable += why.empty() ? 1 : 0;
    }
    EXPECT_GE(choosable, 2) << name << " has only one way to be done";
  }
}

TEST_P(ShippedLayoutsTest, withoutASimulatorOraclesSayWhyTheyCannotBeChosen) {
  if (does("mapping")) return;  // there is no task that an oracle could do
  EXPECT_EQ(
      "unavailable because neither the robot nor another task provides the simulator's ground truth "
      "(oracle/world)",
      unavailability(layout_, registeredTasks(), platform(false), "self-localisation", "oracle"));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLayoutsTest,
                         testing::Values(Shipped{"parallel", "ers210"}, Shipped{"compact", "ers210"},
                                         Shipped{"soccer", "ers210"}, Shipped{"balanced", "ers210"},
                                         Shipped{"ers210-programs", "ers210"}, Shipped{"pioneer", "p3at"},
                                         Shipped{"pioneer-parallel", "p3at"},
                                         Shipped{"pioneer-programs", "p3at"},
                                         Shipped{"pioneer-wander", "p3at"},
                                         Shipped{"pioneer-mapping", "p3at"}, Shipped{"pioneer", "p3dx"},
                                         Shipped{"pioneer-mapping", "peoplebot"}),
                         [](const auto& shipped) {
                           std::string name = std::string(shipped.param.layout) + "_" + shipped.param.robot;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
