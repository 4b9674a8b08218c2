// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/Layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotlink/process/LayoutPrograms.h"

using namespace robotlink;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace std::chrono_literals;

namespace {

/// Perception and motion of a robot with two legs, in few words.
TaskCatalog catalog() {
  TaskCatalog result;
  const auto add = [&](const std::string& task, std::vector<TaskCatalog::Solution> solutions) {
    result.tasks[task] = {task, "", std::move(solutions)};
  };
  add("see", {{"plain", "", {"image"}, {}, {"percept"}}, {"guess", "", {}, {"image", "model"}, {"percept"}}});
  add("model", {{"filter", "", {"percept"}, {"pose"}, {"model"}}, {"oracle", "", {"truth"}, {}, {"model"}}});
  add("locate", {{"particles", "", {"percept", "status"}, {}, {"pose"}}});
  add("behave",
      {{"go", "", {"model"}, {"wish", "status"}, {"request"}}, {"deep", "", {"pose"}, {}, {"request"}}});
  add("move", {{"walk", "", {"request", "joints"}, {}, {"angles", "status"}}});
  return result;
}

PlatformPackages platform() {
  return {{"image", "joints"}, {"angles"}, {"wish"}};
}

/// One process a line: "name [blocking] task solution, task solution".
std::string text(const std::vector<std::string>& processes) {
  std::string result = "version: 1\nname: test\nprocesses:\n";
  for (const std::string& process : processes) result += "  - {" + process + "}\n";
  return result + "  - {name: debug, debug: true, period_ms: 16}\n";
}

Layout layoutOf(const std::vector<std::string>& processes) {
  auto layout = parseLayout(text(processes), "l.yaml");
  if (!layout) throw std::runtime_error(describe(layout.error()));
  return *layout;
}

std::vector<std::string> complaints(const std::vector<std::string>& processes) {
  std::vector<std::string> result;
  for (const Error& error : checkLayout(layoutOf(processes), catalog(), platform()))
    result.push_back(error.describe());
  return result;
}

const std::vector<std::string> kGood = {
    "name: think, blocking: [image], tasks: [see: plain, model: filter, behave: go]",
    "name: act, blocking: [joints], priority: -5, tasks: [move: walk]"};

TEST(LayoutReaderTest, everythingIsRead) {
  const auto layout = parseLayout(
      "version: 1\nname: compact\nhelp: Two processes.\nprocesses:\n"
      "  - name: motion\n    priority: -5\n    period_ms: 7.5\n    blocking: [joints]\n    tasks:\n      - "
      "move: walk\n"
      "  - {name: debug, debug: true, period_ms: 16}\n",
      "l.yaml");
  ASSERT_TRUE(layout) << describe(layout.error());
  EXPECT_EQ("compact", layout->name);
  EXPECT_EQ("Two processes.", layout->help);
  ASSERT_EQ(2U, layout->processes.size());
  const Layout::Process& motion = layout->processes[0];
  EXPECT_EQ("motion", motion.name);
  EXPECT_EQ(-5, motion.priority);
  EXPECT_EQ(Duration(7500us), motion.period);
  EXPECT_FALSE(motion.debug);
  ASSERT_EQ(1U, motion.blocking.size());
  EXPECT_EQ("joints", motion.blocking[0].package);
  ASSERT_EQ(1U, motion.tasks.size());
  EXPECT_EQ("move", motion.tasks[0].task);
  EXPECT_EQ("walk", motion.tasks[0].solution);
  EXPECT_EQ((FilePosition{"l.yaml", 10, 9}), motion.tasks[0].where);
  EXPECT_TRUE(layout->processes[1].debug);
}

TEST(LayoutReaderTest, allErrorsOfFormHaveTheirPlace) {
  const auto layout = parseLayout(
      "version: 2\nname: No Name\nprocesses:\n  - {name: a, priority: 20, period_ms: -1, colour: red, tasks: "
      "[{x: y, z: w}]}\n",
      "l.yaml");
  ASSERT_FALSE(layout);
  std::vector<std::string> ids;
  for (const Error& error : layout.error()) {
    ids.push_back(std::to_string(error.where.line) + ":" + std::to_string(error.where.column) + " " +
                  error.id);
  }
  EXPECT_THAT(ids, ElementsAre("1:10 layout.version", "2:7 layout.name", "4:25 layout.priority",
                               "4:40 layout.period", "4:44 yaml.unknown-key", "4:65 layout.task-form"));
}

TEST(LayoutReaderTest, aMissingFileIsAnErrorThatNamesIt) {
  const auto layout = readLayout("/nowhere/layout.yaml");
  ASSERT_FALSE(layout);
  EXPECT_THAT(describe(layout.error()), HasSubstr("/nowhere/layout.yaml"));
}

TEST(LayoutCheckTest, aGoodLayoutHasNoErrors) {
  EXPECT_THAT(complaints(kGood), IsEmpty());
}

TEST(LayoutCheckTest, anUnknownTaskIsReportedWithTheNearestName) {
  EXPECT_THAT(complaints({"name: think, blocking: [image], tasks: [see: plain, modell: filter]"}),
              ElementsAre("l.yaml:4:58: there is no task 'modell'; did you mean 'model'?"));
}

TEST(LayoutCheckTest, anUnknownSolutionIsReportedWithTheChoice) {
  EXPECT_THAT(complaints({"name: think, blocking: [image], tasks: [see: sharp]"}),
              ElementsAre("l.yaml:4:46: task see has no solution 'sharp'; there are plain, guess"));
}

TEST(LayoutCheckTest, aTaskTwiceIsRefused) {
  EXPECT_THAT(complaints({kGood[0], kGood[1], "name: more, period_ms: 8, tasks: [see: plain]"}),
              ElementsAre("l.yaml:6:40: task see is done already, in line 4; remove one of them"));
}

TEST(LayoutCheckTest, aProcessNameTwiceIsRefused) {
  EXPECT_THAT(complaints({kGood[0], "name: think, blocking: [joints], tasks: [move: walk]"}),
              ElementsAre("l.yaml:5:5: there is a process think already, in line 4; rename one of them"));
}

TEST(LayoutCheckTest, anInputThatNobodyYieldsIsReportedWithTheTaskThatWould) {
  EXPECT_THAT(complaints({"name: think, blocking: [image], tasks: [see: plain, behave: go]"}),
              ElementsAre("l.yaml:4:58: task behave (go) needs model, which no task yields here; add a task "
                          "that does: model"));
}

TEST(LayoutCheckTest, anUnavailableDefaultSolutionIsReportedWithTheOthers) {
  EXPECT_THAT(
      complaints({"name: think, blocking: [image], tasks: [see: plain, model: oracle]"}),
      ElementsAre(
          "l.yaml:4:58: task model (oracle) needs truth, which neither the platform nor a task offers; "
          "choose another solution: filter"));
}

TEST(LayoutCheckTest, anOutputTwiceIsRefused) {
  TaskCatalog twice = catalog();
  twice.tasks["imagine"] = {"imagine", "", {{"all", "", {}, {}, {"percept", "joints"}}}};
  const Errors errors = checkLayout(
      layoutOf({"name: think, blocking: [image], tasks: [see: plain, imagine: all]"}), twice, platform());
  ASSERT_EQ(2U, errors.size());
  EXPECT_EQ("l.yaml:4:58: task imagine yields joints, which the platform also yields; remove one of them",
            errors[0].describe());
  EXPECT_EQ(
      "l.yaml:4:58: task imagine yields percept, which task see (line 4) also yields; remove one of them",
      errors[1].describe());
}

TEST(LayoutCheckTest, aTaskThatComesTooLateIsToBeMovedUp) {
  EXPECT_THAT(
      complaints({"name: think, blocking: [image], tasks: [model: filter, see: plain]"}),
      ElementsAre("l.yaml:4:46: model needs percept of see, which runs after it; move see up, above model"));
}

TEST(LayoutCheckTest, aCycleInsideAProcessIsRefused) {
  TaskCatalog cyclic = catalog();
  cyclic.tasks["see"].solutions[0].required.push_back("request");
  const Errors errors = checkLayout(
      layoutOf({"name: think, blocking: [image], tasks: [see: plain, model: filter, behave: go]"}), cyclic,
      platform());
  ASSERT_EQ(1U, errors.size()) << describe(errors);
  EXPECT_EQ("layout.cycle", errors[0].id);
  EXPECT_THAT(errors[0].text, HasSubstr("see needs request of behave, which needs what see yields"));
}

TEST(LayoutCheckTest, anOptionalInputMayComeFromALaterTask) {
  EXPECT_THAT(complaints({"name: think, blocking: [image], tasks: [see: guess, model: filter]"}), IsEmpty());
}

TEST(LayoutCheckTest, processesMayNeedEachOtherIfTheyDoNotWaitForEachOther) {
  EXPECT_THAT(
      complaints({"name: think, blocking: [image], tasks: [see: plain, locate: particles, behave: deep]",
                  "name: act, blocking: [joints], tasks: [move: walk]"}),
      IsEmpty());
}

TEST(LayoutCheckTest, processesThatWaitForEachOtherAreRefused) {
  EXPECT_THAT(
      complaints({"name: think, blocking: [image, status], tasks: [see: plain, model: filter, behave: go]",
                  "name: act, blocking: [request], tasks: [move: walk]"}),
      ElementsAre(
          "l.yaml:5:28: think waits for act waits for think, so that none of them ever runs; remove a "
          "blocking input, such as request here"));
}

TEST(LayoutCheckTest, aProcessThatNeverWaitsIsRefused) {
  EXPECT_THAT(
      complaints({"name: think, tasks: [see: plain]"}),
      ElementsAre("l.yaml:4:5: process think waits for nothing and would run without pause; give it a "
                  "blocking input or a period_ms"));
}

TEST(LayoutCheckTest, wrongBlockingInputsAreRefused) {
  EXPECT_THAT(
      complaints({"name: think, blocking: [image, image, joints, percept, pose], tasks: [see: plain, model: "
                  "filter]"}),
      ElementsAre(
          "l.yaml:4:37: process think waits for image twice; remove it from 'blocking'",
          "l.yaml:4:44: process think waits for joints, which none of its tasks uses; remove it from "
          "'blocking'",
          "l.yaml:4:52: process think waits for percept, which it yields itself; remove it from 'blocking'",
          "l.yaml:4:61: process think waits for pose, which no task yields here; remove it from 'blocking'"));
}

TEST(LayoutCheckTest, wrongBlockingOutputsAreRefused) {
  EXPECT_THAT(complaints({"name: think, blocking: [image], blocking_outputs: [request], tasks: [see: plain, "
                          "model: filter, behave: go]",
                          kGood[1]}),
              IsEmpty());
  EXPECT_THAT(
      complaints({"name: think, blocking: [image], blocking_outputs: [request, request, angles, percept], "
                  "tasks: [see: plain, model: filter, behave: go]",
                  kGood[1]}),
      ElementsAre("l.yaml:4:66: process think waits until request is taken, twice; remove it from "
                  "'blocking_outputs'",
                  "l.yaml:4:75: process think waits until angles is taken, which none of its tasks yields; "
                  "remove it from 'blocking_outputs'",
                  "l.yaml:4:83: process think waits until percept is taken, but no other process and no "
                  "platform receives it; remove it from 'blocking_outputs'"));
}

/// What is wrong with the good layout with these programs.
std::vector<std::string> complaintsAboutPrograms(const std::string& programs) {
  std::vector<std::string> result;
  const auto layout = parseLayout(text(kGood) + "programs:\n" + programs, "l.yaml");
  const Errors errors = layout ? checkLayout(*layout, catalog(), platform()) : layout.error();
  for (const Error& error : errors) result.push_back(error.describe());
  return result;
}

TEST(LayoutProgramsTest, everyProcessBelongsToOneProgram) {
  const auto layout = parseLayout(text(kGood) +
                                      "programs:\n  - {name: body, processes: [act, debug]}\n"
                                      "  - {name: head, processes: [think]}\n",
                                  "l.yaml");
  ASSERT_TRUE(layout) << describe(layout.error());
  EXPECT_THAT(checkLayout(*layout, catalog(), platform()), IsEmpty());
  ASSERT_EQ(2U, layout->programs.size());
  EXPECT_EQ("body", layout->mainProgram()->name);
  EXPECT_EQ("head", layout->programOf("think")->name);
  EXPECT_EQ(nullptr, layout->findProgram("tail"));
  EXPECT_EQ((FilePosition{"l.yaml", 8, 5}), layout->programs[0].where);
}

TEST(LayoutProgramsTest, wrongProgramsAreRefusedWithTheirPlace) {
  EXPECT_THAT(complaintsAboutPrograms("  - {name: body, processes: [act, debug]}\n"),
              ElementsAre("l.yaml:4:5: process think is run by no program; add it to one of those under "
                          "'programs'"));
  EXPECT_THAT(
      complaintsAboutPrograms("  - {name: body, processes: [act, debug, think]}\n"
                              "  - {name: body, processes: [think, thinks]}\n"
                              "  - {name: tail, processes: []}\n"),
      ElementsAre("l.yaml:9:5: there is a program body already, in line 8; rename one of them",
                  "l.yaml:9:30: process think is run by program body already (line 8); remove it from "
                  "one of them",
                  "l.yaml:9:37: there is no process 'thinks' that program body could run; did you "
                  "mean 'think'?",
                  "l.yaml:10:5: program tail runs no process; give it one or remove it"));
}

TEST(LayoutProgramsTest, hostsAreNamedForAllProgramsOrForNone) {
  EXPECT_THAT(complaintsAboutPrograms("  - {name: body, host: 192.168.1.2, processes: [act, debug]}\n"
                                      "  - {name: head, processes: [think]}\n"),
              ElementsAre("l.yaml:9:5: program head has no host, but others have; name all hosts, or none if "
                          "all run on one machine"));
  EXPECT_THAT(complaintsAboutPrograms("  - {name: body, host: 'a host', processes: [act, think, debug]}\n"),
              ElementsAre("l.yaml:8:24: 'a host' is neither the IP address of a machine nor its name"));
}

TEST(LayoutCheckTest, thereIsExactlyOneDebugProcessWithoutTasks) {
  EXPECT_THAT(
      complaints({"name: extra, debug: true, period_ms: 8, tasks: [see: plain]"}),
      ElementsAre(
          "l.yaml:4:5: the debug process extra has neither tasks nor blocking inputs; move them to "
          "another process",
          "l.yaml:5:5: process debug is a second debug process, in addition to extra; remove one of them"));
  const auto none = parseLayout(
      "version: 1\nname: a\nprocesses: [{name: think, period_ms: 8, tasks: [see: plain]}]\n", "l.yaml");
  ASSERT_TRUE(none);
  const Errors errors = checkLayout(*none, catalog(), platform());
  ASSERT_EQ(1U, errors.size());
  EXPECT_EQ(
      "l.yaml: no process collects the debug messages of the others; add '- {name: debug, debug: true, "
      "period_ms: 16}'",
      errors[0].describe());
}

TEST(LayoutTest, anUnavailableSolutionSaysWhy) {
  const Layout layout = layoutOf(kGood);
  const auto why = [&](const char* task, const char* solution) {
    return unavailability(layout, catalog(), platform(), task, solution);
  };
  EXPECT_EQ("", why("model", "filter"));
  EXPECT_EQ("unavailable because neither the robot nor another task provides truth", why("model", "oracle"));
  EXPECT_EQ("unavailable because neither the robot nor another task provides pose", why("behave", "deep"));
  EXPECT_EQ("unavailable because no process does the task locate", why("locate", "particles"));
  EXPECT_EQ("unavailable because task model has no such solution", why("model", "none"));
}

TEST(LayoutTest, whatOnlyAnUnavailableSolutionYieldsIsNotOffered) {
  TaskCatalog tasks = catalog();
  tasks.tasks["see"].solutions.push_back({"truth", "", {"truth"}, {}, {"perfect"}});
  tasks.tasks["model"].solutions.push_back({"perfect", "", {"perfect"}, {}, {"model"}});
  EXPECT_EQ("unavailable because neither the robot nor another task provides perfect",
            unavailability(layoutOf(kGood), tasks, platform(), "model", "perfect"));
}

TEST(LayoutTest, linksFollowFromInputsAndOutputs) {
  const std::vector<LayoutLink> links = layoutLinks(layoutOf(kGood), catalog(), platform());
  EXPECT_THAT(links, ElementsAre(LayoutLink{"image", "", "think", true, false},
                                 LayoutLink{"wish", "debug", "think", false, true},
                                 LayoutLink{"status", "act", "think", false, true},
                                 LayoutLink{"request", "think", "act", false, false},
                                 LayoutLink{"joints", "", "act", true, false},
                                 LayoutLink{"angles", "act", "", false, true}));
}

TEST(LayoutTest, whatDecidesThroughOthersCommandsThePlatformToo) {
  const std::vector<LayoutLink> links = {
      {"image", "", "see", true, false},         {"percept", "see", "think", true, false},
      {"percept", "see", "draw", true, false},   {"status", "act", "think", false, true},
      {"request", "think", "act", false, false}, {"goal", "debug", "think", false, true},
      {"drawing", "draw", "show", false, false}, {"angles", "act", "", false, true}};
  EXPECT_THAT(commandingProcesses(links), ElementsAre("act", "debug", "see", "think"));
  EXPECT_THAT(commandingProcesses({links.front()}), IsEmpty());
}

TEST(LayoutTest, theGraphShowsProcessesTasksAndPackages) {
  const std::string graph = layoutGraph(layoutOf(kGood), catalog(), platform());
  EXPECT_THAT(graph, HasSubstr("digraph \"test\" {"));
  EXPECT_THAT(
      graph,
      HasSubstr(R"("think" [shape=record, label="{think|see:\ plain\lmodel:\ filter\lbehave:\ go\l}"];)"));
  EXPECT_THAT(graph, HasSubstr(R"("act" [shape=record, label="{act|priority\ -5|move:\ walk\l}"];)"));
  EXPECT_THAT(graph, HasSubstr(R"("platform" -> "think" [label="image"];)"));
  EXPECT_THAT(graph, HasSubstr(R"("think" -> "act" [label="request", style=dashed];)"));
  EXPECT_THAT(graph, HasSubstr(R"("act" -> "debug" [dir=both, style=dotted, constraint=false];)"));
}

}  // namespace
