// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/LoggedPaths.h"

#include <gtest/gtest.h>

#include "foxglove/Scene.pb.h"

namespace app {
namespace {

/// A plan in which a process sees and another one walks; only the first one runs again.
ReplayPlan planThatSees() {
  ReplayPlan plan;
  plan.layout = *robotlink::parseLayout(
      "version: 1\nname: seeing\nhelp: \"\"\nprocesses:\n"
      "  - {name: cognition, tasks: [ball-percept: region]}\n"
      "  - {name: debug, debug: true, period_ms: 16}\n",
      "seeing.yaml");
  const auto add = [&](const std::string& name, bool canRecompute, bool asLogged) {
    ReplayPlan::Package package;
    package.name = name;
    package.process = "cognition";
    package.logged = true;
    package.canRecompute = canRecompute;
    if (asLogged) package.source = robotcontrol::ControlReplay::AS_LOGGED;
    plan.packages.push_back(package);
  };
  add("percepts/ball", true, false);
  add("percepts/landmarks", true, true);
  add("models/ball", false, false);
  return plan;
}

class LoggedPathsTest : public testing::Test {
 protected:
  bool isRecomputed(const std::string& path) const { return paths_.isRecomputed(path, foxglove::Log()); }
  bool isTextRecomputed(const std::string& source) const {
    foxglove::Log text;
    text.set_name(source);
    return paths_.isRecomputed("log", text);
  }

  const LoggedPaths paths_{planThatSees()};
};

TEST_F(LoggedPathsTest, onlyPackagesThatAreComputedAgainMakeWay) {
  EXPECT_TRUE(isRecomputed("percepts/ball"));
  EXPECT_FALSE(isRecomputed("percepts/landmarks")) << "the user wants it as logged";
  EXPECT_FALSE(isRecomputed("models/ball")) << "it cannot be computed";
  EXPECT_FALSE(isRecomputed("camera/image"));
}

TEST_F(LoggedPathsTest, whatIsAboutProcessesAndTasksGoesWithThem) {
  for (const std::string path : {"frames/", "stopwatches/", "tables/keys/", "tables/solutions/"}) {
    EXPECT_TRUE(isRecomputed(path + "cognition")) << path;
    EXPECT_FALSE(isRecomputed(path + "motion")) << path;
  }
  EXPECT_TRUE(isRecomputed("parameters/ball-percept/region"));
  EXPECT_FALSE(isRecomputed("parameters/motion/wheel-model-rectangle"));
  EXPECT_TRUE(isRecomputed("tables/solutions"));
}

TEST_F(LoggedPathsTest, drawingsAndPlotsGoWithTheTasksOfTheirKeys) {
  EXPECT_TRUE(isRecomputed("drawings/image/ball-percept/disc"));
  EXPECT_TRUE(isRecomputed("plots/ball-percept/disc/curve")) << "the curve of a key";
  EXPECT_FALSE(isRecomputed("drawings/field/self-localisation/pose"));
  EXPECT_FALSE(isRecomputed("drawings/image/no-such/key"));
}

TEST_F(LoggedPathsTest, textsGoWithTheirTaskOrElseTheirProcess) {
  EXPECT_TRUE(isTextRecomputed("cognition/ball-percept"));
  EXPECT_FALSE(isTextRecomputed("cognition/self-localisation")) << "a task that does not run there any more";
  EXPECT_TRUE(isTextRecomputed("cognition"));
  EXPECT_FALSE(isTextRecomputed("motion/motion"));
}

TEST_F(LoggedPathsTest, withoutAPlanAllIsAsLogged) {
  const LoggedPaths none;
  EXPECT_FALSE(none.isRecomputed("percepts/ball", foxglove::Log()));
  EXPECT_FALSE(none.isRecomputed("tables/keys", foxglove::Log()));
}

}  // namespace
}  // namespace app
