// SPDX-License-Identifier: GPL-3.0-or-later
// Errors against the truth, and solutions that are compared by them, as `robotctl` prints them.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

class RobotctlErrors : public testing::Test {
 protected:
  RobotctlOutcome robotctl(const std::string& arguments) const {
    return runRobotctl(folder_.path(), arguments);
  }
  const TestFolder folder_;
};

}  // namespace

TEST_F(RobotctlErrors, errorsAgainstTheTruthAreMeasuredAndChangeNothing) {
  const std::string command = "sim " + kScene + " --seconds 2 --json";
  const RobotctlOutcome measured = robotctl(command + " --errors");
  ASSERT_EQ(measured.status, 0) << measured.errors;
  const auto figures = json::parse(measured.out);
  const auto& robot = figures.at("errors").at("red1");
  EXPECT_GT(robot.at("models/pose").at("position").at("count"), 40);
  EXPECT_LT(robot.at("camera/pose").at("direction").at("median"), 0.1) << "rad";
  EXPECT_LT(robot.at("percepts/ball").at("latency").at("mean"), 0.1) << "s";
  EXPECT_EQ(figures.at("digest"), json::parse(robotctl(command).out).at("digest"));
  EXPECT_EQ(robotctl("sim " + kScene + " --trials 1 --errors").status, 2);
}

TEST_F(RobotctlErrors, solutionsAreComparedWithSeedsAndResultsThatAreThereCount) {
  const std::string command = "compare --task ball-model --solutions filtered,oracle --scene " + kScene +
                              " --seeds 2 --seconds 1 --out compared";
  const RobotctlOutcome first = robotctl(command);
  EXPECT_EQ(first.status, 0) << first.errors;
  for (const char* file : {"report.html", "results.csv", "summary.csv", "differences.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / "compared" / file)) << file;
  const auto run = folder_ / "compared/runs/oracle--seed-1.json";
  const auto made = std::filesystem::last_write_time(run);
  EXPECT_EQ(robotctl(command).status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(run), made) << "it is not run again";
  const RobotctlOutcome wrong =
      robotctl("compare --task ball-model --solutions filtred --scene x --out compared");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("did you mean 'filtered'?"));
}

TEST_F(RobotctlErrors, whatHasNoTruthIsComparedByWhatComesOfIt) {
  const RobotctlOutcome outcome =
      robotctl("compare --task motion --solutions wheel-model-rectangle,wheel-model-fast --scene " + kScene +
               " --seeds 2 --seconds 1 --out compared -- --walk 1");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.out + outcome.errors, HasSubstr("The task motion has no ground truth"));
  const std::string report = textOf(folder_ / "compared/report.html");
  EXPECT_THAT(report, HasSubstr("The task motion has no ground truth"));
  EXPECT_THAT(report, HasSubstr("<td>walk forward</td>"));
}

TEST_F(RobotctlErrors, linesAndTheStateOfTheBodyHaveFigures) {
  const RobotctlOutcome outcome = robotctl("sim " + kScene +
                                           " --seconds 2 --layout soccer --shadow line-percepts=oracle "
                                           "--shadow robot-state=oracle --errors --json");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto robot = json::parse(outcome.out).at("errors").at("red1");
  EXPECT_LT(robot.at("percepts/lines").at("points").at("mean"), 0.1) << "m";
  EXPECT_LT(robot.at("shadow/oracle/percepts/lines").at("points").at("mean"), 0.01) << "m";
  EXPECT_EQ(robot.at("shadow/oracle/percepts/lines").at("false"), 0.0);
  EXPECT_EQ(robot.at("shadow/oracle/percepts/robot-state").at("collided").at("mean"), 0.0);
  EXPECT_LT(robot.at("percepts/robot-state").at("fallen").at("mean"), 0.1) << "of the time";
}
