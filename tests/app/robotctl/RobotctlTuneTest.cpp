// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl tune`, and what it is made of: presets, measured walks, shadows with errors of their own.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

class RobotctlTune : public testing::Test {
 protected:
  RobotctlOutcome robotctl(const std::string& arguments) const {
    return runRobotctl(folder_.path(), arguments);
  }
  json figures(const std::string& arguments) const {
    const RobotctlOutcome outcome = robotctl("sim " + kScene + " --threads 1 --json " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }
  /// How often each line of a CSV file has a word.
  int rowsWith(const std::string& file, const std::string& word) const {
    std::istringstream lines(textOf(folder_ / file));
    int count = 0;
    for (std::string line; std::getline(lines, line);) count += line.find(word) != std::string::npos ? 1 : 0;
    return count;
  }
  TestFolder folder_;
};

/// A few candidates for how fast the robot may walk.
std::string tuneSpeed(int evaluations) {
  return "tune --task motion --solution wheel-model-rectangle --robot ers210 --scene " + kScene +
         " --parameter gait.maximum_x=0.08:0.18 --figure 'walk forward' --maximize --seeds 1 --held-out 2"
         " --seconds 1.5 --algorithms crs2,sbplx --evaluations " +
         std::to_string(evaluations) + " --out tuned -- --walk 0.5";
}

}  // namespace

TEST_F(RobotctlTune, aWalkIsMeasuredAndTheSeedVariesIt) {
  const json fast = figures("--walk 0.15 --seconds 2 --seed 1"),
             other = figures("--walk 0.15 --seconds 2 --seed 2");
  const double forward = fast["walk"]["forward"];
  EXPECT_NEAR(forward, 0.15, 0.03);
  EXPECT_FALSE(fast["walk"]["fell"]);
  EXPECT_NE(other["walk"]["forward"].get<double>(), forward);
  EXPECT_EQ(figures("--walk 0.15 --seconds 2 --seed 1"), fast);
  const double back = figures("--walk=-0.1 --seconds 2")["walk"]["forward"];
  EXPECT_NEAR(back, -0.1, 0.03);
}

TEST_F(RobotctlTune, betterParametersAreFoundWrittenAndNotSearchedTwice) {
  // Slow today, so that there is something to be found.
  const RobotctlOutcome first = robotctl(tuneSpeed(8));
  EXPECT_TRUE(first.status == 0 || first.out.find("not better") != std::string::npos) << first.errors;
  EXPECT_THAT(first.out, HasSubstr("walk forward with 2 held-out seeds"));
  EXPECT_GE(rowsWith("tuned/course.csv", "crs2"), 1);
  EXPECT_GE(rowsWith("tuned/course.csv", "sbplx"), 1);
  const std::string file = textOf(folder_ / "tuned/motion.wheel-model-rectangle.textproto");
  EXPECT_THAT(file, HasSubstr("# The gait of the solution wheel-model-rectangle")) << "comments stay";
  EXPECT_THAT(textOf(folder_ / "tuned/tuned.preset.json"), HasSubstr("gait.maximum_x"));
  EXPECT_THAT(textOf(folder_ / "tuned/report.html"), HasSubstr("robotctl tune --task motion"));
  // The same command has its results already, and comes to the same.
  const auto written = [&] {
    std::filesystem::file_time_type newest{};
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "tuned/runs"))
      newest = std::max(newest, entry.last_write_time());
    return newest;
  };
  const auto before = written();
  const RobotctlOutcome second = robotctl(tuneSpeed(8));
  EXPECT_EQ(second.out, first.out);
  EXPECT_EQ(written(), before);
}

TEST_F(RobotctlTune, whatCannotBeTunedIsSaid) {
  const std::string rest = " --robot ers210 --scene " + kScene + " --figure x --out o";
  EXPECT_THAT(robotctl("tune --task motion --solution fly --parameter a" + rest).errors,
              HasSubstr("the task motion has no solution 'fly'; there are "));
  EXPECT_THAT(
      robotctl("tune --task motion --solution wheel-model-rectangle --parameter gait.hop" + rest).errors,
      HasSubstr("gait.hop is not a numeric parameter of motion/wheel-model-rectangle"));
  const RobotctlOutcome figure = robotctl(
      "tune --task motion --solution wheel-model-rectangle --parameter gait.factor_x --evaluations 2 "
      "--seconds 1" +
      rest + " -- --walk 0.1");
  EXPECT_THAT(figure.errors, HasSubstr("the runs have no figure 'x'"));
  EXPECT_THAT(figure.errors, HasSubstr("walk forward"));
  EXPECT_NE(figure.status, 0);
}

TEST_F(RobotctlTune, theTunedSolutionRunsAlthoughTheLayoutHasAnother) {
  const std::string fast = "tune --task motion --solution wheel-model-fast --robot ers210 --scene " + kScene +
                           " --parameter gait.maximum_x --figure 'walk forward' --maximize --seeds 1 "
                           "--held-out 2 --seconds 1 --algorithms crs2 --evaluations 3 --out fast -- ";
  const RobotctlOutcome outcome = robotctl(fast + "--walk 1");
  EXPECT_THAT(outcome.out, HasSubstr("walk forward with 2 held-out seeds")) << outcome.errors;
  std::set<std::string> figures;
  std::istringstream course(textOf(folder_ / "fast/course.csv"));
  for (std::string line; std::getline(course, line);)
    figures.insert(line.substr(0, line.rfind(',')).substr(2));
  EXPECT_GE(figures.size(), 3U) << "its parameters matter";
  // A robot that stands does not walk faster.
  const std::string slow = "tune --task motion --solution wheel-model-rectangle --robot ers210 --scene " +
                           kScene +
                           " --parameter gait.maximum_x --figure ball_contacts --seeds 1 --held-out 2 "
                           "--seconds 0.2 --evaluations 9 --out slow";
  EXPECT_THAT(robotctl(slow).errors, HasSubstr("the first 4 candidates all have 0 of 'ball_contacts'"));
  EXPECT_THAT(robotctl(slow + " -- --solution behavior=nope").errors, HasSubstr("has no solution 'nope'"));
}

TEST_F(RobotctlTune, shadowsHaveErrorsOfTheirOwnAndChangeNothing) {
  const json plain = figures("--seconds 3 --errors");
  const json shadowed =
      figures("--seconds 3 --errors --shadow ball-model=last-percept --shadow self-localisation=odometry");
  EXPECT_EQ(plain["digest"], shadowed["digest"]);
  EXPECT_EQ(plain["errors"]["red1"]["models/ball"], shadowed["errors"]["red1"]["models/ball"]);
  EXPECT_TRUE(shadowed["errors"]["red1"].contains("shadow/last-percept/models/ball"));
  EXPECT_TRUE(shadowed["errors"]["red1"].contains("shadow/odometry/models/pose"));
  EXPECT_THAT(robotctl("sim " + kScene + " --seconds 0.1 --shadow ball-model=magic").errors,
              HasSubstr("task ball-model has no solution 'magic'"));
}
