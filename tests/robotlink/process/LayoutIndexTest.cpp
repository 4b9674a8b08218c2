// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/LayoutIndex.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robotlink {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class LayoutIndexTest : public testing::Test {
 protected:
  LayoutIndexTest() {
    task("see", {{"plain", "", {"image"}, {}, {"percept"}}});
    task("model", {{"filter", "", {"percept"}, {"pose"}, {"model"}},
                   {"oracle", "", {"truth"}, {}, {"model", "score"}}});
    task("echo", {{"loop", "", {"echoed"}, {}, {"echoed"}}});
    process("think", {"see", "model"});
    process("act", {"echo"});
    layout.processes.push_back({});
    layout.processes.back().name = "debug";
    layout.processes.back().debug = true;
  }
  void task(const std::string& name, std::vector<TaskCatalog::Solution> solutions) {
    catalog.tasks[name] = {name, "", std::move(solutions)};
  }
  void process(const std::string& name, const std::vector<std::string>& tasks) {
    Layout::Process process;
    process.name = name;
    for (const auto& task : tasks) process.tasks.push_back({task, "any", {}});
    layout.processes.push_back(std::move(process));
  }
  LayoutIndex index() const { return {layout, catalog, platform}; }
  const TaskCatalog::Solution& solution(const std::string& task, const std::string& name) const {
    return *catalog.find(task, name);
  }

  Layout layout;
  TaskCatalog catalog;
  PlatformPackages platform{{"image"}, {}, {"wish"}};
};

TEST_F(LayoutIndexTest, tasksAreFoundInTheirProcesses) {
  const LayoutIndex index = this->index();
  ASSERT_THAT(index.places(), SizeIs(3));
  const auto* model = index.placeOf("model");
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->process->name, "think");
  EXPECT_EQ(model->position, 1U);
  EXPECT_EQ(index.placeOf("behave"), nullptr);
}

TEST_F(LayoutIndexTest, unknownAndRepeatedTasksAreLeftOut) {
  process("again", {"see", "nonsense"});
  const LayoutIndex index = this->index();
  EXPECT_THAT(index.places(), SizeIs(3));
  EXPECT_EQ(index.placeOf("see")->process->name, "think");
}

TEST_F(LayoutIndexTest, aPackageComesFromTheTaskWithAnySolutionForIt) {
  const LayoutIndex index = this->index();
  ASSERT_NE(index.producer("score"), nullptr);
  EXPECT_EQ(index.producer("score")->entry->task, "model");
  EXPECT_EQ(index.producer("image"), nullptr) << "that is the platform's";
}

TEST_F(LayoutIndexTest, aSolutionRunsIfAllThatItNeedsIsOffered) {
  const LayoutIndex index = this->index();
  EXPECT_EQ(index.obstacle(*index.placeOf("model"), solution("model", "filter")), "");
  EXPECT_THAT(index.obstacle(*index.placeOf("model"), solution("model", "oracle")), HasSubstr("truth"));
}

TEST_F(LayoutIndexTest, whatDependsOnAMissingSensorIsNotOfferedEither) {
  platform.offers.clear();
  const LayoutIndex index = this->index();
  EXPECT_NE(index.obstacle(*index.placeOf("see"), solution("see", "plain")), "");
  EXPECT_THAT(index.obstacle(*index.placeOf("model"), solution("model", "filter")), HasSubstr("percept"));
}

TEST_F(LayoutIndexTest, aTaskCannotWaitForItself) {
  const LayoutIndex index = this->index();
  EXPECT_THAT(index.obstacle(*index.placeOf("echo"), solution("echo", "loop")), HasSubstr("echoed"));
}

TEST_F(LayoutIndexTest, aTaskThatRunsBeforeItsSourceInTheSameProcessIsReportedSo) {
  layout.processes.front().tasks = {{"model", "filter", {}}, {"see", "plain", {}}};
  const LayoutIndex index = this->index();
  const auto obstacle = index.obstacle(*index.placeOf("model"), "percept");
  EXPECT_THAT(obstacle.reason, HasSubstr("later"));
  ASSERT_NE(obstacle.later, nullptr);
  EXPECT_EQ(obstacle.later->entry->task, "see");
}

TEST_F(LayoutIndexTest, twoProcessesMayNeedEachOthersPackages) {
  task("left", {{"a", "", {"image", "right"}, {}, {"left"}}});
  task("right", {{"b", "", {"left"}, {}, {"right"}}});
  process("first", {"left"});
  process("second", {"right"});
  const LayoutIndex index = this->index();
  EXPECT_EQ(index.obstacle(*index.placeOf("left"), solution("left", "a")), "");
  EXPECT_EQ(index.obstacle(*index.placeOf("right"), solution("right", "b")), "");
}

TEST_F(LayoutIndexTest, withheldPackagesAreNoOutputs) {
  layout.withheld = {"score"};
  const LayoutIndex index = this->index();
  EXPECT_THAT(index.outputsOf(catalog.tasks.at("model")), ElementsAre("model"));
  EXPECT_EQ(index.producer("score"), nullptr);
}

TEST_F(LayoutIndexTest, theDebugProcessOffersItsPackagesIfThereIsOne) {
  EXPECT_TRUE(index().debugOffers("wish"));
  EXPECT_EQ(index().debugProcess()->name, "debug");
  layout.processes.pop_back();
  EXPECT_FALSE(index().debugOffers("wish"));
  EXPECT_EQ(index().debugProcess(), nullptr);
}

TEST_F(LayoutIndexTest, readingIsNeedingOrUsing) {
  const auto& filter = solution("model", "filter");
  EXPECT_TRUE(LayoutIndex::needs(filter, "percept") && LayoutIndex::reads(filter, "percept"));
  EXPECT_TRUE(!LayoutIndex::needs(filter, "pose") && LayoutIndex::reads(filter, "pose"));
  EXPECT_FALSE(LayoutIndex::reads(filter, "model"));
}

TEST_F(LayoutIndexTest, anEmptyLayoutHasNothing) {
  layout = {};
  EXPECT_THAT(index().places(), IsEmpty());
  EXPECT_EQ(index().producer("model"), nullptr);
}

}  // namespace
}  // namespace robotlink
