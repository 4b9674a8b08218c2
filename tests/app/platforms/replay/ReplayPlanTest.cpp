// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayPlan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace app;
using robotcontrol::ControlReplay;
using robotlink::TaskCatalog;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace {

/// regions <- image; pose <- joints; percept <- regions, pose; model <- percept or oracle; walk <- model,
/// uses status: steps and status.
TaskCatalog catalog() {
  TaskCatalog all;
  const auto add = [&](const std::string& task, TaskCatalog::Solution solution) {
    all.tasks[task].name = task;
    all.tasks[task].solutions.push_back(std::move(solution));
  };
  add("segment", {"lines", "", {"image"}, {}, {"regions"}});
  add("locate", {"kinematic", "", {"image", "joints"}, {}, {"pose"}});
  add("see", {"fit", "", {"regions", "pose"}, {}, {"percept"}});
  add("believe", {"truth", "", {"oracle"}, {}, {"model"}});
  add("believe", {"filter", "", {"percept"}, {"status"}, {"model"}});
  add("walk", {"gait", "", {"joints"}, {"model"}, {"steps", "status"}});
  return all;
}

constexpr char kLayout[] = R"(
version: 1
name: toy
processes:
  - name: cognition
    blocking: [image]
    tasks:
      - segment: lines
      - locate: kinematic
      - see: fit
      - believe: filter
  - name: motion
    blocking: [joints]
    tasks:
      - walk: gait
  - {name: debug, debug: true, period_ms: 16}
)";

ReplaySelection wishesFor(std::set<std::string> logged, const std::string& text = kLayout) {
  ReplaySelection selection;
  auto layout = robotlink::parseLayout(text, "toy.yaml");
  EXPECT_TRUE(layout.has_value());
  if (layout) selection.layout = std::move(*layout);
  selection.logged = std::move(logged);
  return selection;
}

ReplayPlan planned(ReplaySelection selection) {
  auto plan = planReplay(std::move(selection), catalog());
  EXPECT_TRUE(plan.has_value()) << (plan ? "" : robotlink::describe(plan.error()));
  return plan ? std::move(*plan) : ReplayPlan{};
}

std::vector<std::string> tasksOf(const ReplayPlan& plan) {
  std::vector<std::string> tasks;
  for (const auto& process : plan.layout.processes) {
    for (const auto& task : process.tasks)
      tasks.push_back(process.name + "/" + task.task + ":" + task.solution);
  }
  return tasks;
}

const robotlink::Layout::Process& process(const ReplayPlan& plan, const std::string& name) {
  for (const auto& candidate : plan.layout.processes) {
    if (candidate.name == name) return candidate;
  }
  throw std::runtime_error("no process " + name);
}

std::string idOf(ReplaySelection selection) {
  const auto plan = planReplay(std::move(selection), catalog());
  return plan || plan.error().empty() ? "" : plan.error().front().id;
}

}  // namespace

TEST(ReplayPlan, fromSensorsAloneEverythingIsRecomputed) {
  const ReplayPlan plan = planned(wishesFor({"image", "joints"}));
  EXPECT_THAT(tasksOf(plan),
              ElementsAre("cognition/segment:lines", "cognition/locate:kinematic", "cognition/see:fit",
                          "cognition/believe:filter", "motion/walk:gait"));
  EXPECT_THAT(plan.unavailable, IsEmpty());
  EXPECT_TRUE(plan.isAsLogged("image"));
  EXPECT_FALSE(plan.find("image")->canRecompute);
  EXPECT_EQ(plan.find("image")->whyNot, "no task of layout toy yields it");
  EXPECT_EQ(plan.find("percept")->process, "cognition");
  EXPECT_EQ(plan.find("image")->process, "");
}

TEST(ReplayPlan, whateverIsLoggedTakesThePlaceOfItsProducers) {
  const ReplayPlan plan =
      planned(wishesFor({"image", "joints", "regions", "pose", "percept", "model", "steps", "status"}));
  EXPECT_THAT(tasksOf(plan), IsEmpty());
  EXPECT_EQ(plan.layout.processes.size(), 1U) << "only the debug process is left";
  ASSERT_EQ(plan.layout.absent.size(), 5U);
  EXPECT_EQ(plan.layout.absent.back().task, "walk");
  EXPECT_EQ(plan.layout.absent.back().reason, "its output is taken from the log: status, steps");
  EXPECT_THAT(plan.unavailable, IsEmpty()) << "they could run";
}

TEST(ReplayPlan, whatOnlyOtherSolutionsYieldIsNotComputedUnlessAPersonWantsIt) {
  TaskCatalog all = catalog();
  all.tasks["walk"].solutions.push_back({"dance", "", {"joints"}, {}, {"steps", "music"}});
  const std::set<std::string> logged{"image",   "joints", "regions", "pose",
                                     "percept", "model",  "steps",   "status"};
  ReplaySelection selection = wishesFor(logged);
  const auto plan = planReplay(selection, all);
  ASSERT_TRUE(plan);
  EXPECT_THAT(tasksOf(*plan), IsEmpty()) << "the gait, which was recorded, makes no music";
  selection.packages["music"] = ControlReplay::RECOMPUTED;
  const auto wanted = planReplay(selection, all);
  ASSERT_TRUE(wanted);
  EXPECT_THAT(tasksOf(*wanted), ElementsAre("motion/walk:gait"));
}

TEST(ReplayPlan, aLoggedPoseLetsARobotWithoutJointsBeSeenThrough) {
  const ReplayPlan plan = planned(wishesFor({"image", "pose"}));
  EXPECT_THAT(tasksOf(plan),
              ElementsAre("cognition/segment:lines", "cognition/see:fit", "cognition/believe:filter"));
  EXPECT_THAT(plan.unavailable, ElementsAre("walk: neither the robot nor another task provides joints"));
  EXPECT_EQ(std::ranges::find(plan.layout.processes, "motion", &robotlink::Layout::Process::name),
            plan.layout.processes.end());
  EXPECT_FALSE(plan.find("steps")->canRecompute);
  EXPECT_EQ(plan.find("steps")->whyNot, "neither the robot nor another task provides joints");
  EXPECT_EQ(plan.find("pose")->whyNot, "neither the robot nor another task provides joints");
}

TEST(ReplayPlan, whatLacksInputsByWayOfOthersGoesToo) {
  const ReplayPlan plan = planned(wishesFor({"image"}));
  EXPECT_THAT(tasksOf(plan), ElementsAre("cognition/segment:lines"));
  EXPECT_THAT(plan.unavailable, ElementsAre("locate: neither the robot nor another task provides joints",
                                            "see: neither the robot nor another task provides pose",
                                            "believe: neither the robot nor another task provides percept",
                                            "walk: neither the robot nor another task provides joints"));
}

TEST(ReplayPlan, anotherSolutionIsTakenWhereTheWishedOneCannotRunAndThatIsSaid) {
  ReplaySelection selection = wishesFor({"image", "joints"});
  selection.layout.processes[0].tasks[3].solution = "truth";
  const ReplayPlan plan = planned(std::move(selection));
  EXPECT_THAT(tasksOf(plan), ::testing::Contains("cognition/believe:filter"));
  EXPECT_THAT(plan.notes, ElementsAre("task believe is done by filter, because truth is unavailable: neither "
                                      "the robot nor another task provides oracle"));
}

TEST(ReplayPlan, oneOfTwoPackagesOfATaskCanBeAsLogged) {
  const ReplayPlan plan = planned(wishesFor({"image", "joints", "status"}));
  EXPECT_THAT(tasksOf(plan), ::testing::Contains("motion/walk:gait"));
  EXPECT_THAT(plan.layout.withheld, ElementsAre("status"));
  EXPECT_TRUE(plan.isAsLogged("status"));
  EXPECT_FALSE(plan.isAsLogged("steps"));
}

TEST(ReplayPlan, allThatCanBeIsRecomputedButWhatAPersonChose) {
  ReplaySelection selection =
      wishesFor({"image", "joints", "regions", "pose", "percept", "model", "steps", "status"});
  selection.recomputeAll = true;
  selection.packages["model"] = ControlReplay::AS_LOGGED;
  const ReplayPlan plan = planned(selection);
  EXPECT_TRUE(plan.isAsLogged("image"));
  EXPECT_TRUE(plan.isAsLogged("model"));
  for (const char* package : {"regions", "pose", "percept"})
    EXPECT_FALSE(plan.isAsLogged(package)) << package;
}

TEST(ReplayPlan, aPersonsChoiceCountsMore) {
  ReplaySelection selection =
      wishesFor({"image", "joints", "regions", "pose", "percept", "model", "steps", "status"});
  selection.packages["percept"] = ControlReplay::RECOMPUTED;
  const ReplayPlan plan = planned(selection);
  EXPECT_THAT(tasksOf(plan), ElementsAre("cognition/see:fit"));
  EXPECT_TRUE(plan.find("percept")->chosen);
  EXPECT_FALSE(plan.find("model")->chosen);
  // It reads no image, but ran once for each.
  ASSERT_EQ(process(plan, "cognition").blocking.size(), 1U);
  EXPECT_EQ(process(plan, "cognition").blocking[0].package, "image");
  EXPECT_TRUE(process(plan, "cognition").blocking[0].paceOnly);
}

TEST(ReplayPlan, withoutWhatSetItsPaceAProcessGoesByWhatItNeeds) {
  ReplaySelection selection = wishesFor({"percept", "status"});
  const ReplayPlan plan = planned(selection);
  EXPECT_THAT(tasksOf(plan), ElementsAre("cognition/believe:filter"));
  ASSERT_EQ(process(plan, "cognition").blocking.size(), 1U);
  EXPECT_EQ(process(plan, "cognition").blocking[0].package, "percept");
}

TEST(ReplayPlan, choicesThatCannotBeAreRefused) {
  ReplaySelection selection = wishesFor({"image", "pose"});
  selection.packages["image"] = ControlReplay::RECOMPUTED;
  EXPECT_EQ(idOf(selection), "replay.cannot-recompute");
  selection.packages = {{"steps", ControlReplay::RECOMPUTED}};
  const auto plan = planReplay(selection, catalog());
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().front().text,
            "steps cannot be recomputed: neither the robot nor another task provides joints");
  selection.packages = {{"percept", ControlReplay::AS_LOGGED}};
  EXPECT_EQ(idOf(selection), "replay.not-logged");
  selection.packages = {{"smell", ControlReplay::AS_LOGGED}};
  EXPECT_EQ(idOf(selection), "replay.no-package");
  selection.packages = {{"smell", ControlReplay::AUTOMATIC}};
  EXPECT_EQ(idOf(selection), "");
}

TEST(ReplayPlan, aSolutionThatCannotBeMadeIsUnavailableForItsOwnReason) {
  ReplaySelection selection = wishesFor({"image", "joints"});
  selection.broken[{"walk", "gait"}] = "the robot has no leg";
  const ReplayPlan plan = planned(selection);
  EXPECT_THAT(plan.unavailable, ElementsAre("walk: the robot has no leg"));
}

TEST(ReplayPlan, aLayoutOfAnOlderProgramLosesWhatIsGoneOneOfAPersonIsRefused) {
  std::string text = kLayout;
  text.replace(text.find("- segment: lines"), 16, "- segment: circles\n      - smell: nose");
  ReplaySelection selection = wishesFor({"image", "joints"}, text);
  EXPECT_EQ(idOf(selection), "layout.unknown-solution");
  selection.fromLog = true;
  const ReplayPlan plan = planned(selection);
  EXPECT_THAT(tasksOf(plan), ::testing::Contains("cognition/segment:lines"));
  EXPECT_THAT(plan.unavailable, ElementsAre("smell: this program has no such task"));
  EXPECT_THAT(plan.notes,
              ElementsAre(HasSubstr("circles is unavailable: this program has no such solution")));
}
