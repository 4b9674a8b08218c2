// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Solution.h"

using namespace robotlink;
using testing::ElementsAre;

namespace {

SolutionDescription named(const std::string& task, const std::string& name) {
  SolutionDescription description;
  description.task = task;
  description.name = name;
  return description;
}

// In a child process, so that this program's solutions stay as they are.
void registerSolution(SolutionDescription description) {
  const SolutionRegistration registration(std::move(description));
}

}  // namespace

TEST(SolutionRegistry, solutionsOfAnObjectLibraryAreKnownWithAllTheySay) {
  const SolutionDescription* solution = SolutionRegistry::find("registry-test", "first");
  ASSERT_NE(solution, nullptr);
  EXPECT_THAT(solution->required, ElementsAre("camera/image"));
  EXPECT_THAT(solution->optional, ElementsAre("oracle/world"));
  EXPECT_THAT(solution->outputs, ElementsAre("percepts/ball"));
  EXPECT_THAT(solution->keys, ElementsAre(DebugKey::find("registry-test/edge")));
  EXPECT_EQ(solution->parameters->GetTypeName(), "robotcontrol.KeyMode");
  EXPECT_TRUE(solution->create);
  EXPECT_EQ(SolutionRegistry::find("registry-test", "third"), nullptr);
  EXPECT_EQ(SolutionRegistry::find("registry-tes", "first"), nullptr);
}

TEST(SolutionRegistry, allAreInOrderOfTasksAndNames) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const auto& solution : SolutionRegistry::all()) names.emplace_back(solution.task, solution.name);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_GE(names.size(), 2U);
}

TEST(SolutionRegistryDeathTest, whatCannotBeRegisteredEndsTheProgramWithAReason) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(registerSolution(named("registry-test", "first")),
               "\"first\" of task \"registry-test\": registered twice");
  EXPECT_DEATH(registerSolution(named("registry-test", "")), "need names");
  SolutionDescription early = named("registry-test", "early");
  early.keys.push_back(-1);
  EXPECT_DEATH(registerSolution(early), "declare its keys above it");
}
