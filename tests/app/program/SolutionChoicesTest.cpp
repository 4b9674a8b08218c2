// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/SolutionChoices.h"

#include <gtest/gtest.h>

#include "robotlink/process/Layout.h"

namespace app {
namespace {

using robotlink::Layout;
using robotlink::TaskCatalog;

TaskCatalog choiceCatalog() {
  TaskCatalog choiceCatalog;
  for (const auto& [task, solutions] : std::map<std::string, std::vector<std::string>>{
           {"ball-percept", {"region", "circle-fit"}}, {"motion", {"wheel-model"}}}) {
    TaskCatalog::Task added;
    added.name = task;
    for (const std::string& name : solutions) {
      TaskCatalog::Solution solution;
      solution.name = name;
      added.solutions.push_back(solution);
    }
    choiceCatalog.tasks[task] = added;
  }
  return choiceCatalog;
}

Layout layoutWith(const std::string& task) {
  Layout layout;
  layout.processes.emplace_back();
  layout.processes[0].tasks.push_back({task, "any", {}});
  return layout;
}

std::string problems(const std::map<std::string, std::string>& solutions,
                     const std::vector<Layout>& layouts) {
  std::vector<const Layout*> pointers;
  for (const Layout& layout : layouts) pointers.push_back(&layout);
  return describe(checkSolutions(solutions, choiceCatalog(), pointers));
}

TEST(SolutionChoices, whatOneOfTheLayoutsHasIsFine) {
  EXPECT_EQ(problems({}, {}), "");
  EXPECT_EQ(problems({{"ball-percept", "circle-fit"}, {"motion", "wheel-model"}},
                     {layoutWith("motion"), layoutWith("ball-percept")}),
            "");
}

TEST(SolutionChoices, tasksAndSolutionsThatThereAreNoneOfAreSaidWithThoseThatThereAre) {
  const std::vector<Layout> one{layoutWith("ball-percept")};
  EXPECT_EQ(problems({{"telepathy", "any"}}, one), "there is no task 'telepathy'; there are ball-percept");
  EXPECT_EQ(problems({{"motion", "wheel-model"}}, one),
            "no robot here has the task 'motion' in its layout; there are ball-percept");
  EXPECT_EQ(problems({{"ball-percept", "guess"}}, one),
            "task ball-percept has no solution 'guess'; it has circle-fit, region");
  EXPECT_EQ(problems({{"motion", "wheel-model"}}, {}),
            "no robot here has the task 'motion' in its layout; no robot has any task");
}

TEST(SolutionChoices, allThatIsWrongIsSaidAtOnce) {
  const auto layout = layoutWith("ball-percept");
  EXPECT_EQ(
      checkSolutions({{"a", "b"}, {"ball-percept", "guess"}, {"c", "d"}}, choiceCatalog(), {&layout}).size(),
      3U);
}

TEST(SolutionChoices, aTextChoosesForAllOrForOneRobotOrTeam) {
  const auto all = solutionChoiceOf("motion=wheel-model", "--shadow");
  ASSERT_TRUE(all);
  EXPECT_EQ(all->name + "|" + all->task + "|" + all->solution, "|motion|wheel-model");
  const auto one = solutionChoiceOf("red/motion=wheel-model", "--shadow");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->name + "|" + one->task + "|" + one->solution, "red|motion|wheel-model");
  for (const char* wrong : {"motion", "=wheel-model", "motion=", "/motion=a", "red/=a"}) {
    const auto none = solutionChoiceOf(wrong, "--shadow");
    ASSERT_FALSE(none) << wrong;
    EXPECT_NE(none.error().text.find("--shadow takes"), std::string::npos);
  }
}

TEST(SolutionChoices, whatIsUsedCannotRunInTheShadow) {
  Layout used = layoutWith("ball-percept"), other = used;
  used.processes[0].tasks[0].choose("region");
  const auto wrong = [&](const robotlink::ShadowName& shadow, const std::vector<const Layout*>& layouts) {
    return describe(checkShadows({shadow}, choiceCatalog(), layouts));
  };
  EXPECT_NE(wrong({"ball-percept", "region"}, {&used}).find("is the solution that is used"),
            std::string::npos);
  EXPECT_EQ(wrong({"ball-percept", "region"}, {&used, &other}), "") << "one of them uses another";
  EXPECT_EQ(wrong({"ball-percept", "circle-fit"}, {&used}), "");
  EXPECT_NE(wrong({"motion", "wheel-model"}, {&used}).find("no robot here has the task"), std::string::npos);
}

}  // namespace
}  // namespace app
