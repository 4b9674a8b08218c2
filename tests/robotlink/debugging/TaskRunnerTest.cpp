// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/TaskRunner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/TestFolder.h"
#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

namespace {

/// A task of the toy robot, whose packages the test sends.
class TaskRunnerTest : public ::testing::Test {
 protected:
  TaskRunnerTest() { robot_.name = "red1"; }
  std::unique_ptr<TaskRunner> runner(const std::string& task = "ball-percept",
                                     const ParameterSource& parameters = {}) {
    auto made = std::make_unique<TaskRunner>(
        task, TaskRunner::Environment{robot_, clock_, debug_, board_, withheld_});
    errors_ = made->loadParameters(parameters);
    return made;
  }
  void receive(const std::string& package, PackagePtr value) {
    board_.send(board_.entry(package), std::move(value));
  }
  void receiveImage(unsigned width) {
    auto image = std::make_shared<foxglove::RawImage>();
    image->set_width(width);
    receive(kCameraImage.name, image);
  }
  /// What the solution "region" has sent: the image's width plus its parameter, and the number of its images.
  const robotcontrol::BallPercept* ball() {
    return static_cast<const robotcontrol::BallPercept*>(board_.entry(kBallPercept.name).value.get());
  }
  /// Parameters of "region" that were recorded.
  static robotcontrol::ParameterValues recorded(const std::string& task, double x) {
    robotcontrol::Velocity2 value;
    value.set_x(x);
    robotcontrol::ParameterValues values;
    values.set_task(task);
    values.set_solution("region");
    values.mutable_value()->set_type("robotcontrol.Velocity2");
    values.mutable_value()->set_data(value.SerializeAsString());
    return values;
  }

  TestFolder folder_;
  ManualClock clock_;
  ToyPlatform process_{"toy", clock_};
  DebugContext debug_{"toy", clock_, {}};
  PackageBoard board_{process_, debug_};
  RobotSetup robot_;
  std::set<std::string> withheld_;
  Errors errors_;
};

TEST_F(TaskRunnerTest, itsSolutionsAreThoseOfItsTask) {
  const auto task = runner();
  std::vector<std::string> names;
  for (const SolutionDescription* solution : task->solutions()) names.push_back(solution->name);
  EXPECT_THAT(names, UnorderedElementsAre("region", "broken", "untidy"));
  EXPECT_THAT(runner("nothing")->solutions(), IsEmpty());
}

TEST_F(TaskRunnerTest, aPackageIsNewInOneFrame) {
  const auto task = runner();
  ASSERT_TRUE(task->select("region"));
  task->execute();
  EXPECT_EQ(ball(), nullptr);
  receiveImage(7);
  task->execute();
  ASSERT_NE(ball(), nullptr);
  EXPECT_EQ(ball()->radius_in_image(), 7);
  const std::uint64_t sent = board_.entry(kBallPercept.name).arrivals;
  task->execute();
  EXPECT_EQ(board_.entry(kBallPercept.name).arrivals, sent);
  receiveImage(8);
  task->execute();
  EXPECT_EQ(ball()->confidence(), 2) << "it is the same object still";
}

TEST_F(TaskRunnerTest, aSolutionThatIsSelectedStartsAfreshWithTheNewestPackage) {
  const auto task = runner();
  ASSERT_TRUE(task->select("region"));
  receiveImage(7);
  task->execute();
  ASSERT_TRUE(task->select("region"));
  EXPECT_EQ(livingSolutions(), 1);
  receiveImage(9);
  task->execute();
  EXPECT_EQ(ball()->confidence(), 1);
  EXPECT_EQ(ball()->radius_in_image(), 9);
}

TEST_F(TaskRunnerTest, aSolutionThatCannotBeMadeLeavesThePreviousOne) {
  const auto task = runner();
  ASSERT_TRUE(task->select("region"));
  for (const auto& [name, id, why] :
       {std::tuple{"broken", "solution.broken", "no color table for red1"},
        {"untidy", "solution.broken", "uses the input models/pose, which its registration does not name"},
        {"none", "solution.unknown", "task ball-percept has no solution 'none'"}}) {
    const auto selected = task->select(name);
    ASSERT_FALSE(selected);
    EXPECT_EQ(selected.error().id, id);
    EXPECT_THAT(selected.error().text, HasSubstr(why));
    EXPECT_EQ(task->trySolution(name).error().text, selected.error().text);
  }
  EXPECT_EQ(task->active(), "region");
  receiveImage(7);
  task->execute();
  EXPECT_EQ(ball()->confidence(), 1);
}

TEST_F(TaskRunnerTest, aTrialLeavesNothingBehind) {
  const auto task = runner();
  EXPECT_TRUE(task->trySolution("region"));
  EXPECT_EQ(livingSolutions(), 0);
  EXPECT_EQ(task->active(), "");
}

TEST_F(TaskRunnerTest, aPackageThatIsWithheldIsNotSent) {
  withheld_.insert(kBallPercept.name);
  const auto task = runner();
  ASSERT_TRUE(task->select("region"));
  receiveImage(7);
  task->execute();
  EXPECT_EQ(ball(), nullptr);
}

TEST_F(TaskRunnerTest, anExceptionSaysWhoseItIs) {
  const auto task = runner("ball-model");
  ASSERT_TRUE(task->select("throwing"));
  try {
    task->execute();
    FAIL();
  } catch (const std::exception& exception) {
    EXPECT_STREQ(exception.what(), "ball-model (throwing): the ball has no covariance");
  }
}

TEST_F(TaskRunnerTest, parametersComeFromFilesAndThoseThatWereRecordedReplaceThem) {
  folder_.write("ball-percept.region.textproto", "x: 2");
  const auto xOf = [](const TaskRunner& task) {
    return static_cast<const robotcontrol::Velocity2*>(task.parameters("region")->message())->x();
  };
  EXPECT_EQ(xOf(*runner("ball-percept", {folder_.path(), {}})), 2);
  EXPECT_THAT(errors_, IsEmpty());
  EXPECT_EQ(xOf(*runner("ball-percept", {folder_.path(), {recorded("ball-percept", 3)}})), 3);
  EXPECT_EQ(xOf(*runner("ball-percept", {folder_.path(), {recorded("ball-model", 3)}})), 2)
      << "of another task";
  EXPECT_EQ(runner()->parameters("none"), nullptr);
}

TEST_F(TaskRunnerTest, filesOfNoSolutionAndMistakesInFilesAreReported) {
  folder_.write("ball-percept.regoin.textproto", "x: 2");
  folder_.write("ball-percept.region.textproto", "x: far");
  folder_.write("ball-percept.notes.txt", "mine");
  folder_.write("ball.region.textproto", "x: 2");
  runner("ball-percept", {folder_.path(), {}});
  ASSERT_EQ(errors_.size(), 2U);
  EXPECT_THAT(errors_[0].text, HasSubstr("has no solution 'regoin'"));
  EXPECT_THAT(errors_[0].text, HasSubstr("region"));
  EXPECT_EQ(errors_[0].where.file, folder_ / "ball-percept.regoin.textproto");
  EXPECT_EQ(errors_[1].where.file, folder_ / "ball-percept.region.textproto");
  EXPECT_EQ(errors_[1].where.line, 1);
}

}  // namespace
