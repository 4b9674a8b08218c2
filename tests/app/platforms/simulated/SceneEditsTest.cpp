// SPDX-License-Identifier: GPL-3.0-or-later
// Models and robots that are added and removed while a scene runs, with their programs.
#include <gmock/gmock.h>

#include <map>

#include "app/core/program/ShippedFiles.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "simcore/Scene.h"
#include "tests/app/SimulatedRuns.h"

using namespace app;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

namespace {

simcore::ModelToAdd modelAt(const std::string& model, double x, double y) {
  return {.model = model, .place = {x, y, 0}};
}

class SceneEditsTest : public testing::Test {
 protected:
  void start(const std::string& scene = "field2002") {
    RunOptions options = test::simulationOptions();
    options.scene = sceneNamed(scene);
    start(std::move(options));
  }
  void start(RunOptions options) {
    run_ = test::makeRun(
        options, {[this](const std::string& robot, const auto&) { ++queues_[robot]; },
                  [this](const std::string&, const auto&, const std::string& text) { troubles_ += text; }});
    ASSERT_NE(run_, nullptr);
  }
  void add(const simcore::ModelToAdd& model) {
    const auto done = run_->addModel(model);
    EXPECT_TRUE(done.has_value()) << (done ? "" : robotlink::describe(done.error()));
  }
  /// How often a robot's program reports in some time.
  int reportsOf(const std::string& robot, double seconds) {
    queues_.clear();
    test::play(*run_, seconds);
    return queues_[robot];
  }
  bool has(const std::string& model) const { return run_->world().simulation().modelPose(model).has_value(); }

  std::map<std::string, int> queues_;
  std::string troubles_;
  std::unique_ptr<SimulatedRun> run_;
};

/// What a run is that is changed at certain steps.
std::uint64_t digestAfterEdits(std::uint64_t seed) {
  RunOptions options = test::simulationOptions(seed);
  const auto run = test::makeRun(options);
  if (!run) return 0;
  test::play(*run, 0.4);
  EXPECT_TRUE(run->addModel(modelAt("burger", 1, 0.6)));
  EXPECT_TRUE(run->addModel(modelAt("p3at", -1.2, -0.9)));
  test::play(*run, 0.4);
  EXPECT_TRUE(run->removeModel("burger1"));
  test::play(*run, 0.4);
  EXPECT_TRUE(run->undoEdit());
  test::play(*run, 0.4);
  return run->world().digest();
}

}  // namespace

TEST_F(SceneEditsTest, anAddedRobotOfAnotherKindRunsItsOwnProgramAndTheOthersGoOn) {
  start();
  const int before = reportsOf("red1", 0.5);
  add(modelAt("burger", 1, 0.6));
  EXPECT_THAT(run_->robots(), ElementsAre("red1", "burger1"));
  EXPECT_EQ(run_->otherLayouts().at("burger1").stem(), "pioneer");
  EXPECT_GT(reportsOf("burger1", 0.5), 5);
  EXPECT_NEAR(queues_["red1"], before, 0.2 * before);
  // Twice 0.5 s, in whole steps.
  EXPECT_EQ(run_->world().clock().now(), robotlink::Instant(std::chrono::milliseconds(1008)));
  EXPECT_EQ(run_->description("burger1")->name, "burger");
  EXPECT_EQ(troubles_, "");
}

TEST_F(SceneEditsTest, theProgramOfARemovedRobotEndsAndTheOthersKeepTheirSensors) {
  start();
  add({.model = "ers210", .place = {0.8, 0.3, 3}, .team = "blue"});
  ASSERT_THAT(run_->robots(), ElementsAre("red1", "blue1"));
  ASSERT_GT(reportsOf("blue1", 0.5), 5);
  ASSERT_TRUE(run_->removeModel("red1/link:head"));
  EXPECT_THAT(run_->robots(), ElementsAre("blue1"));
  EXPECT_FALSE(has("red1"));
  EXPECT_GT(reportsOf("blue1", 0.5), 5);
  EXPECT_EQ(queues_["red1"], 0);
  // It still stands, so it reads and sets its own joints.
  EXPECT_GT(run_->world().simulation().modelPose("blue1")->translation().z(), 0.08);
  EXPECT_EQ(troubles_, "");
}

TEST_F(SceneEditsTest, aRemovedModelComesBackAsItWas) {
  start();
  test::play(*run_, 0.4);
  const auto before = run_->world().simulation().modelPose("red1").value();
  ASSERT_TRUE(run_->removeModel("red1"));
  EXPECT_EQ(run_->undoable(), "the removal of red1");
  ASSERT_TRUE(run_->undoEdit());
  EXPECT_THAT(run_->robots(), ElementsAre("red1"));
  EXPECT_TRUE(run_->world().simulation().modelPose("red1")->isApprox(before, 1e-9));
  EXPECT_GT(reportsOf("red1", 0.3), 2);
  EXPECT_FALSE(run_->undoEdit().has_value()) << "there is nothing more to take back";
}

TEST_F(SceneEditsTest, anAdditionCanBeTakenBackAndACopyStandsBeside) {
  start("pioneer");
  const auto copied = run_->duplicateModel("p3at1", "");
  ASSERT_TRUE(copied.has_value()) << robotlink::describe(copied.error());
  EXPECT_THAT(run_->robots(), ElementsAre("p3at1", "p3at2"));
  const robotlink::Vector3 way = run_->world().simulation().modelPose("p3at1")->translation() -
                                 run_->world().simulation().modelPose("p3at2")->translation();
  EXPECT_GT(way.norm(), 0.5);
  EXPECT_LT(way.norm(), 3);
  EXPECT_GT(reportsOf("p3at2", 0.5), 2);
  ASSERT_TRUE(run_->undoEdit());
  EXPECT_THAT(run_->robots(), ElementsAre("p3at1"));
  EXPECT_GT(reportsOf("p3at1", 0.5), 2);
}

TEST_F(SceneEditsTest, thereIsNoRoomWhereSomethingStandsNow) {
  start();
  test::play(*run_, 0.2);
  const auto done = run_->addModel(modelAt("p3at", -0.8, 0));
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().front().id, "scene.no-room");
  EXPECT_THAT(run_->robots(), ElementsAre("red1"));
  EXPECT_EQ(run_->undoable(), "");
  EXPECT_GT(reportsOf("red1", 0.3), 2) << "all goes on";
}

TEST_F(SceneEditsTest, whatCannotBeAddedOrRemovedIsRefusedByName) {
  start();
  const auto unknown = run_->addModel(modelAt("unicorn", 1, 1));
  ASSERT_FALSE(unknown.has_value());
  EXPECT_THAT(unknown.error().front().text, HasSubstr("unicorn"));
  simcore::ModelToAdd again = modelAt("burger", 1, 1);
  again.name = "red1";
  const auto taken = run_->addModel(again);
  ASSERT_FALSE(taken.has_value());
  EXPECT_THAT(taken.error().front().text, HasSubstr("red1"));
  const auto missing = run_->removeModel("nobody");
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().front().text, HasSubstr("nobody"));
}

TEST_F(SceneEditsTest, aRobotWhoseProgramCannotRunIsNotAdded) {
  RunOptions options = test::simulationOptions();
  options.robotLayouts["p3at1"] = layoutNamed("compact");
  start(std::move(options));
  test::play(*run_, 0.2);
  const auto done = run_->addModel(modelAt("p3at", 1.2, 0.6));
  ASSERT_FALSE(done.has_value());
  EXPECT_THAT(run_->robots(), ElementsAre("red1"));
  EXPECT_FALSE(has("p3at1"));
  EXPECT_GT(reportsOf("red1", 0.3), 2);
}

TEST_F(SceneEditsTest, theSameChangesAtTheSameStepsGiveTheSameBytes) {
  const std::uint64_t first = digestAfterEdits(3);
  EXPECT_EQ(digestAfterEdits(3), first);
  EXPECT_NE(digestAfterEdits(4), first);
}

TEST_F(SceneEditsTest, aResetKeepsTheModelsThatThereAre) {
  start();
  add(modelAt("burger", 1, 0.6));
  test::play(*run_, 0.2);
  ASSERT_TRUE(run_->reset(5).empty());
  EXPECT_THAT(run_->robots(), UnorderedElementsAre("red1", "burger1"));
  EXPECT_GT(reportsOf("burger1", 0.5), 2);
}
