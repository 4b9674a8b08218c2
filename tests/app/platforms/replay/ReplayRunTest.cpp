// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of the simulated robot, played.
#include "app/platforms/replay/ReplayRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "foxglove/Image.pb.h"
#include "foxglove/Scene.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/app/platforms/replay/ReplayFixture.h"

using namespace app;
using namespace app::test;
using namespace std::chrono_literals;
using robotcontrol::ControlReplay;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace {

const std::string kRegions = "red1/percepts/regions";

/// Two seconds of the simulated robot, recorded once for all tests.
class ReplayRunTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TestFolder>();
    recordSimulation(file(), "compact", 254, [](SimulatedRun& run, int step) {
      if (step == 20) (void)run.request(keyRequest("red1", "segmentation/regions"));
      if (step == 20) (void)run.request(keyRequest("red1", "camera-pose/horizon"));
    });
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::filesystem::path file() { return *folder_ / "sim.mcap"; }
  static ReplayOptions recomputingRegions() {
    ReplayOptions options = replayOf({{file()}});
    options.packages[kRegions] = ControlReplay::RECOMPUTED;
    options.publishAllPackages = true;
    return options;
  }
  static inline std::unique_ptr<TestFolder> folder_;
};

}  // namespace

class RecomputedLayout : public ::testing::TestWithParam<std::string> {};

/// With requests at times at which the debug process does not run.
TEST_P(RecomputedLayout, aRecordingOfTheSimulatedRobotGivesTheRecordedBytes) {
  const TestFolder folder;
  const auto file = folder / "sim.mcap";
  recordSimulation(file, GetParam(), 400, [](SimulatedRun& run, int step) {
    if (step == 101) (void)run.request(selectRequest("red1", "ball-model", "last-percept"));
    if (step == 203) (void)run.request(selectRequest("red1", "segmentation", "whole-image"));
    if (step == 250) (void)run.request(selectRequest("red1", "behavior", "obey"));
    if (step != 254) return;
    robotcontrol::Request request;
    request.set_robot("red1");
    request.mutable_motion()->mutable_motion()->set_kind(robotcontrol::MotionRequest::WALK);
    request.mutable_motion()->mutable_motion()->mutable_walk()->set_x(0.05);
    (void)run.request(request);
  });
  Replay replay(recomputingAll(file));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  replay.playToEnd();
  EXPECT_THAT(replay.troubles, IsEmpty());
  const auto status = replay.status();
  EXPECT_THAT(status.unavailable_tasks(), IsEmpty());
  EXPECT_GE(recomputedPackages(status).size(), 12U);
  // The solutions that were chosen do not send all packages of their tasks.
  const auto compared = std::ranges::count_if(status.packages(), [](const auto& package) {
    return package.source() == robotcontrol::ControlReplay::RECOMPUTED && package.can_recompute() &&
           package.logged();
  });
  EXPECT_EQ(status.differences_size(), compared);
  for (const auto& difference : status.differences()) {
    EXPECT_GT(difference.compared(), 70U) << difference.package();
    EXPECT_EQ(difference.different(), 0U)
        << difference.package() << " first at " << difference.first_time() << ", "
        << difference.largest_field() << " by " << difference.largest();
    EXPECT_EQ(difference.only_logged(), 0U) << difference.package();
    EXPECT_EQ(difference.only_recomputed(), 0U) << difference.package();
  }
}

/// It localizes itself in the map, which the log holds.
TEST(ReplayRun, aRecordingOfAPioneerGivesTheRecordedBytes) {
  const TestFolder folder;
  const auto map = folder / "room.map";
  std::ofstream(map)
      << "2D-Map\nCairn: RobotHome 1000 1000 0 \"\" ICON \"Home\"\nLINES\n0 0 6000 0\n6000 0 6000 4000\n"
         "6000 4000 0 4000\n0 4000 0 0\n3000 0 3000 1500\nDATA\n";
  RunOptions options;
  options.scene = map;
  options.solutions["driving"] = "wander";
  recordSimulation(folder / "sim.mcap", options, 1000);
  std::filesystem::remove(map);
  Replay replay(recomputingAll(folder / "sim.mcap"));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  replay.playToEnd();
  EXPECT_THAT(replay.troubles, IsEmpty());
  const auto status = replay.status();
  EXPECT_EQ(recomputedPackages(status).size(), 5U);
  for (const auto& difference : status.differences()) {
    EXPECT_GT(difference.compared(), 10U) << difference.package();
    EXPECT_EQ(difference.different() + difference.only_logged() + difference.only_recomputed(), 0U)
        << difference.package() << " first at " << difference.first_time() << ", "
        << difference.largest_field();
  }
}

TEST(ReplayRun, aLayoutThatWasChangedInTheRecordingChangesInItsReplay) {
  const TestFolder folder;
  const auto file = folder / "sim.mcap";
  recordSimulation(file, "compact", 304, [](SimulatedRun& run, int step) {
    if (step != 131) return;
    EXPECT_TRUE(run.setLayout(robotlink::resource("layouts/parallel.yaml")).empty());
  });
  Replay replay(recomputingAll(file));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  replay.playToEnd();
  EXPECT_EQ(replay.countOn("red1/frames/self-localisation"),
            replay.countOn("red1/logged/frames/self-localisation"));
  EXPECT_GT(replay.countOn("red1/frames/self-localisation"), 20U);
  const auto status = replay.status();
  EXPECT_GE(status.differences_size(), 12);
  for (const auto& difference : status.differences()) {
    EXPECT_GT(difference.compared(), 50U) << difference.package();
    EXPECT_EQ(difference.different(), 0U) << difference.package() << " first at " << difference.first_time();
  }
}

INSTANTIATE_TEST_SUITE_P(Layouts, RecomputedLayout, ::testing::Values("compact", "balanced", "parallel"),
                         [](const auto& layout) { return layout.param; });

TEST_F(ReplayRunTest, byItselfItPlaysWhatIsLoggedAndComputesNothing) {
  Replay replay(file());
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  EXPECT_THAT(recomputedPackages(replay.status()), IsEmpty());
  EXPECT_THAT(replay.run->robots(), ::testing::ElementsAre("red1"));
  EXPECT_EQ(replay.run->now(), replay.run->begin());
  EXPECT_EQ(replay.run->stepProcess(), "red1/cognition");
  replay.playToEnd();
  EXPECT_EQ(replay.run->now(), at(2.032));
  EXPECT_EQ(replay.run->now(), replay.run->end());
  EXPECT_EQ(replay.countOn("red1/camera/image"), 50U);
  EXPECT_EQ(replay.countOn(kRegions), 50U);
  EXPECT_EQ(replay.countOn("red1/logged/percepts/regions"), 0U);
  EXPECT_GT(replay.countOn("red1/drawings/image/segmentation/regions"), 10U);
  EXPECT_GT(replay.countOn("transforms"), 10U);
  EXPECT_EQ(replay.status().differences_size(), 0);
  ASSERT_TRUE(replay.run->description("red1"));
  EXPECT_EQ(replay.run->description("red1")->name, "ers210");
  EXPECT_TRUE(replay.run->field());
}

TEST_F(ReplayRunTest, oneRecomputedPackageAmongLoggedOnesIsTheSameToTheBit) {
  Replay replay(recomputingRegions());
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  EXPECT_THAT(recomputedPackages(replay.status()), ::testing::ElementsAre(kRegions));
  replay.playToEnd();
  const auto status = replay.status();
  ASSERT_EQ(status.differences_size(), 1);
  EXPECT_EQ(status.differences(0).compared(), 50U);
  EXPECT_EQ(status.differences(0).different(), 0U);
  EXPECT_EQ(replay.countOn(kRegions), 50U);
  EXPECT_EQ(replay.digestOn(kRegions), replay.digestOn("red1/logged/percepts/regions"));
}

TEST_F(ReplayRunTest, whatIsRecomputedTakesThePathAndWhatWasLoggedStandsBesideIt) {
  ReplayOptions options = recomputingRegions();
  Replay replay(options);
  ASSERT_TRUE(replay.run);
  ASSERT_TRUE(replay.run->request(keyRequest("red1", "segmentation/regions")));
  replay.playToEnd();
  // What the task that runs publishes...
  EXPECT_GT(replay.countOn("red1/logged/drawings/image/segmentation/regions"), 10U);
  EXPECT_GT(replay.countOn("red1/drawings/image/segmentation/regions"), 45U) << "from the first frame on";
  EXPECT_EQ(replay.countOn("red1/logged/frames/cognition"), 50U);
  EXPECT_EQ(replay.countOn("red1/frames/cognition"), 50U);
  // ...and of one that does not, in a process that does.
  EXPECT_EQ(replay.countOn("red1/logged/drawings/image/camera-pose/horizon"), 0U);
  const StreamMessage* horizon = replay.lastOn("red1/drawings/image/camera-pose/horizon");
  ASSERT_NE(horizon, nullptr);
  EXPECT_EQ(horizon->process, "cognition");
  EXPECT_EQ(horizon->frame, 0U) << "the process counts its frames from zero: drawings go by time";
  // The platform and processes that do not run.
  EXPECT_EQ(replay.countOn("red1/frames/platform"), 254U);
  EXPECT_EQ(replay.countOn("red1/logged/frames/motion"), 0U);
  EXPECT_EQ(replay.countOn("red1/camera/image"), 50U);
}

TEST_F(ReplayRunTest, theColorTableInUseIsThatOfTheLogOrTheOneThatIsBuiltIn) {
  const auto sourcesIn = [](const Replay& replay) {
    std::vector<std::string> sources;
    for (const auto& message : replay.reported) {
      if (message.path != "red1/tables/colors") continue;
      const auto& source = dynamic_cast<const robotcontrol::ColorTable&>(*message.value).source();
      if (sources.empty() || sources.back() != source) sources.push_back(source);
    }
    return sources;
  };
  Replay builtIn(recomputingRegions());
  ASSERT_TRUE(builtIn.run);
  builtIn.playToEnd();
  EXPECT_THAT(sourcesIn(builtIn), ::testing::ElementsAre("built-in"));

  const auto file = *folder_ / "table.mcap";
  recordSimulation(file, "compact", 200, [](SimulatedRun& run, int step) {
    if (step == 100) (void)run.request(tableRequest());
  });
  Replay played(file);
  ASSERT_TRUE(played.run);
  played.playToEnd();
  EXPECT_THAT(sourcesIn(played), ::testing::ElementsAre("built-in", "/home/me/orange.c64"))
      << "as it was then";
  ReplayOptions options = recomputingRegions();
  options.logs = {{file}};
  Replay recomputed(options);
  ASSERT_TRUE(recomputed.run);
  recomputed.playToEnd();
  EXPECT_THAT(sourcesIn(recomputed), ::testing::ElementsAre("built-in", "of the log: /home/me/orange.c64"));
  EXPECT_EQ(recomputed.status().differences(0).different(), 0U);
  recomputed.reported.clear();
  ASSERT_TRUE(recomputed.run->jump(at(1.5)).empty());
  EXPECT_EQ(sourcesIn(recomputed).back(), "of the log: /home/me/orange.c64");
}

TEST_F(ReplayRunTest, anotherSolutionGivesOtherBytesAndTheFirstOneItsOwnAgain) {
  Replay first(recomputingRegions());
  ASSERT_TRUE(first.run);
  first.playToEnd();
  const std::string before = first.digestOn(kRegions);
  EXPECT_FALSE(before.empty());
  ReplayOptions options = recomputingRegions();
  options.solutions["segmentation"] = "whole-image";
  Replay other(options);
  ASSERT_TRUE(other.run) << robotlink::describe(other.errors);
  other.playToEnd();
  EXPECT_NE(other.digestOn(kRegions), before);
  EXPECT_GT(other.status().differences(0).different(), 0U);
  EXPECT_FALSE(other.status().differences(0).largest_field().empty());

  // The same by switching, and stepping over the same frames again.
  ASSERT_TRUE(other.run->request(selectRequest("red1", "segmentation", "scan-lines")));
  other.reported.clear();
  ASSERT_TRUE(other.run->jump(other.run->begin()).empty());
  other.playToEnd();
  EXPECT_EQ(other.digestOn(kRegions), before);
  EXPECT_EQ(other.status().differences(0).different(), 0U);
}

TEST_F(ReplayRunTest, aJumpPublishesTheNewestOfEveryStreamAndOfNumbersALittleMore) {
  ReplayOptions options = replayOf({{file()}});
  options.preroll = 100ms;
  Replay replay(options);
  ASSERT_TRUE(replay.run);
  ASSERT_TRUE(replay.run->jump(at(1.003)).empty());
  EXPECT_EQ(replay.run->now(), at(1.003));
  EXPECT_EQ(replay.run->nextTime(), at(1.008));
  EXPECT_EQ(replay.countOn("red1/camera/image"), 1U);
  EXPECT_EQ(replay.lastOn("red1/camera/image")->time, at(1.0));
  EXPECT_EQ(replay.lastOn("red1/joints/states")->time, at(1.0));
  EXPECT_EQ(replay.countOn("red1/joints/states"), 13U) << "0.904 s to 1 s";
  EXPECT_EQ(replay.countOn("red1/percepts/ball"), 3U) << "0.92 s to 1 s";
  EXPECT_EQ(replay.countOn("scene"), 1U);
  EXPECT_EQ(replay.countOn("red1/program"), 1U);
  EXPECT_EQ(replay.countOn("red1/logged/program"), 1U);
  EXPECT_EQ(replay.countOn("red1/tables/solutions"), 1U);
  for (std::size_t i = 1; i < replay.reported.size(); ++i)
    EXPECT_LE(replay.reported[i - 1].time, replay.reported[i].time);
  const auto* drawing = replay.lastOn("red1/drawings/image/segmentation/regions");
  ASSERT_NE(drawing, nullptr);
  EXPECT_EQ(drawing->frame, replay.lastOn("red1/frames/cognition")->frame)
      << "a drawing of the last whole frame";
  // On from there without a gap.
  replay.reported.clear();
  ASSERT_TRUE(replay.run->step());
  EXPECT_EQ(replay.lastOn("red1/joints/states")->time, at(1.008));
}

TEST_F(ReplayRunTest, aJumpRunsTheProgramsOnWhatIsBefore) {
  ReplayOptions options = recomputingAll(file());
  options.publishAllPackages = true;
  options.preroll = 10s;  // all of it
  Replay played(options);
  ASSERT_TRUE(played.run);
  while (played.run->now() < at(1.2)) ASSERT_TRUE(played.run->step());
  Replay jumped(options);
  ASSERT_TRUE(jumped.run->jump(at(1.2)).empty());
  for (const char* path :
       {"red1/models/ball", "red1/models/pose", "red1/motion/status", "red1/logged/models/pose"}) {
    ASSERT_NE(jumped.lastOn(path), nullptr) << path;
    EXPECT_EQ(jumped.lastOn(path)->value->SerializeAsString(),
              played.lastOn(path)->value->SerializeAsString())
        << path;
  }
  // And both go on alike.
  played.reported.clear();
  jumped.reported.clear();
  played.playToEnd();
  jumped.playToEnd();
  EXPECT_EQ(jumped.digestOn("red1/joints/request"), played.digestOn("red1/joints/request"));
  EXPECT_FALSE(jumped.digestOn("red1/joints/request").empty());
  // Nobody heard what was computed on the way: one instant counts, and what came after it.
  const auto status = jumped.status();
  for (const auto& difference : status.differences())
    EXPECT_LE(difference.compared(), 102U) << difference.package();
}

TEST_F(ReplayRunTest, framesAreCountedFromNowAndFoundByTheirNumbers) {
  Replay replay(file());
  ASSERT_TRUE(replay.run);
  ReplayRun& run = *replay.run;
  ASSERT_TRUE(run.jump(at(1.0)).empty());
  EXPECT_EQ(run.frameTime("red1/cognition", 1), at(1.04));
  EXPECT_EQ(run.frameTime("red1/cognition", -1), at(0.96));
  EXPECT_EQ(run.frameTime("red1/cognition", 1000), at(2.0));
  EXPECT_EQ(run.frameTime("red1/cognition", -1000), at(0.04));
  EXPECT_EQ(run.frameTime("red1/motion", 1), at(1.008));
  EXPECT_FALSE(run.frameTime("red1/nobody", 1));
  EXPECT_FALSE(run.frameTime("nonsense", 1));
  EXPECT_EQ(run.timeOfFrame("red1/cognition", 3), at(0.12));
  EXPECT_FALSE(run.timeOfFrame("red1/cognition", 3000));
  EXPECT_EQ(run.messageTime("red1/camera/image", 2), at(1.08));
  EXPECT_EQ(run.messageTime("red1/camera/image", -1), at(0.96));
  EXPECT_TRUE(run.messageTime("transforms", 1));
  EXPECT_FALSE(run.messageTime("red1/nothing", 1));
  EXPECT_EQ(replay.status().frame(), 25U);
  EXPECT_EQ(replay.status().frame_index(), 25U);
  EXPECT_TRUE(run.setStepProcess("red1/motion"));
  EXPECT_EQ(replay.status().step_process(), "red1/motion");
  EXPECT_EQ(replay.status().frame(), 125U);
  EXPECT_FALSE(run.setStepProcess("red1/nobody"));
  EXPECT_EQ(run.stepProcess(), "red1/motion");
}

TEST_F(ReplayRunTest, packagesCanBeChosenWhileItPlaysAndWhatCannotBeChangesNothing) {
  Replay replay(file());
  ASSERT_TRUE(replay.run->jump(at(1)).empty());
  ASSERT_TRUE(replay.run->choosePackages({{kRegions, ControlReplay::RECOMPUTED}}).empty());
  EXPECT_EQ(replay.run->now(), at(1));
  EXPECT_THAT(recomputedPackages(replay.status()), ::testing::ElementsAre(kRegions));
  const auto refused = replay.run->choosePackages({{"red1/camera/image", ControlReplay::RECOMPUTED}});
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].id, "replay.cannot-recompute");
  EXPECT_EQ(replay.run->choosePackages({{"blue7/camera/image", ControlReplay::RECOMPUTED}}).front().id,
            "replay.no-robot");
  EXPECT_THAT(recomputedPackages(replay.status()), ::testing::ElementsAre(kRegions));
  ASSERT_TRUE(replay.run->choosePackages({{kRegions, ControlReplay::AUTOMATIC}}).empty());
  EXPECT_THAT(recomputedPackages(replay.status()), IsEmpty());
}

TEST_F(ReplayRunTest, aLayoutCanBeChosenAndABadOneChangesNothing) {
  Replay replay(recomputingAll(file()));
  ASSERT_TRUE(replay.run);
  ASSERT_TRUE(replay.run->setLayout(robotlink::resource("layouts/parallel.yaml")).empty());
  EXPECT_EQ(replay.run->options().layout.stem(), "parallel");
  replay.reported.clear();
  for (int i = 0; i < 100; ++i) replay.run->step();
  EXPECT_GT(replay.countOn("red1/frames/self-localisation"), 5U);
  const auto bad = *folder_ / "bad.yaml";
  std::ofstream(bad) << "version: 1\nname: bad\n";
  EXPECT_FALSE(replay.run->setLayout(bad).empty());
  EXPECT_EQ(replay.run->options().layout.stem(), "parallel");
  replay.reported.clear();
  for (int i = 0; i < 50; ++i) replay.run->step();
  EXPECT_GT(replay.countOn("red1/frames/self-localisation"), 2U);
  // Nor where the log's own layout is in use.
  Replay asLogged(file());
  EXPECT_FALSE(asLogged.run->setLayout("/no/such.yaml").empty());
  EXPECT_EQ(asLogged.run->options().layout, "");
}

TEST_F(ReplayRunTest, requestsAreAnsweredAlsoOverAJumpAndKeysStay) {
  Replay replay(recomputingRegions());
  ASSERT_TRUE(replay.run->jump(at(0.5)).empty());
  replay.reported.clear();
  replay.results.clear();
  auto request = keyRequest("red1", "segmentation/regions");
  request.set_id(77);
  ASSERT_TRUE(replay.run->request(request));
  // It waits while nothing moves; a jump to where one is shows what it changes.
  ASSERT_TRUE(replay.run->jump(replay.run->now()).empty());
  ASSERT_EQ(replay.results.size(), 1U);
  EXPECT_EQ(replay.results[0].id(), 77U);
  EXPECT_TRUE(replay.results[0].accepted());
  const auto* drawing = replay.lastOn("red1/drawings/image/segmentation/regions");
  ASSERT_NE(drawing, nullptr);
  EXPECT_EQ(drawing->time, at(0.48));
  robotcontrol::Request stop;
  stop.set_robot("red1");
  stop.mutable_stop()->set_engaged(true);
  EXPECT_THAT(replay.run->request(stop).error().text, HasSubstr("cannot be controlled"));
  EXPECT_FALSE(replay.run->request(keyRequest("blue7", "segmentation/regions")));
}

TEST_F(ReplayRunTest, aTaskThatIsReplacedSaysSoAndCannotBeSwitched) {
  Replay replay(file());
  ASSERT_TRUE(replay.run->jump(at(0.5)).empty());
  const auto* table =
      dynamic_cast<const robotcontrol::SolutionTable*>(replay.lastOn("red1/tables/solutions")->value.get());
  ASSERT_NE(table, nullptr);
  bool found = false;
  for (const auto& task : table->tasks()) {
    if (task.name() != "segmentation") continue;
    found = true;
    for (const auto& solution : task.solutions()) {
      EXPECT_EQ(solution.unavailable(),
                "unavailable because its output is taken from the log: percepts/regions");
    }
  }
  EXPECT_TRUE(found);
  auto request = selectRequest("red1", "segmentation", "whole-image");
  request.set_id(5);
  ASSERT_TRUE(replay.run->request(request));
  for (int i = 0; i < 3; ++i) replay.run->step();
  ASSERT_EQ(replay.results.size(), 1U);
  EXPECT_FALSE(replay.results[0].accepted());
}

TEST_F(ReplayRunTest, severalLogsShareOneTimeLineWithOffsets) {
  ReplayOptions options = replayOf({{file()}, {file(), 500ms}});
  options.publishAllPackages = true;
  options.packages["*/percepts/regions"] = ControlReplay::RECOMPUTED;
  Replay replay(options);
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  EXPECT_THAT(replay.run->robots(), ::testing::ElementsAre("red1", "red1-2"));
  EXPECT_EQ(replay.run->begin(), at(0));
  EXPECT_EQ(replay.run->end(), at(2.532));
  replay.playToEnd();
  EXPECT_EQ(replay.countOn(kRegions), 50U);
  EXPECT_EQ(replay.digestOn(kRegions), replay.digestOn("red1-2/percepts/regions"))
      << "an offset changes no bytes";
  EXPECT_EQ(replay.lastOn("red1-2/percepts/regions")->time, at(2.5));
  EXPECT_EQ(replay.lastOn("red1-2/camera/image")->time, at(2.5));
  EXPECT_EQ(replay.countOn("scene"), 1U) << "of the first log";
  ASSERT_TRUE(replay.run->setOffsets({{file(), 0ms}}).empty());
  EXPECT_EQ(replay.run->end(), at(2.032));
  EXPECT_EQ(replay.status().logs(1).offset(), 0);
  ASSERT_TRUE(replay.run->jump(at(1)).empty());
  EXPECT_EQ(replay.countOn("scene"), 3U) << "and at each jump";
}

TEST_F(ReplayRunTest, afterAJumpTheLoggedPackageIsThereToBeComparedWith) {
  ReplayOptions options = replayOf({ReplayLog{file()}});
  options.packages["*/percepts/regions"] = ControlReplay::RECOMPUTED;
  Replay replay(options);
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  const auto instant = replay.run->messageTime(kRegions, 10);
  ASSERT_TRUE(instant);
  ASSERT_TRUE(replay.run->jump(*instant).empty());
  const auto status = replay.status();
  ASSERT_EQ(status.differences_size(), 1);
  EXPECT_EQ(status.differences(0).compared(), 1U);
  EXPECT_EQ(status.differences(0).only_recomputed(), 0U);
  EXPECT_EQ(status.differences(0).only_logged(), 0U);
}

TEST_F(ReplayRunTest, aLogOfAnotherTimeBeginsWithTheFirst) {
  const TestFolder folder;
  const auto later = folder / "later.mcap";
  {
    auto writer = logplayer::LogWriter::create(later, {});
    const auto value = std::make_shared<robotcontrol::PlotValue>();
    for (const double time : {5000.0, 5001.0})
      ASSERT_TRUE((*writer)->write({{"blue1/plots/a", at(time), value}}));
  }
  Replay replay(replayOf({ReplayLog{file()}, ReplayLog{later}}));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  EXPECT_EQ(replay.status().logs(1).begin(), replay.status().logs(0).begin());
  EXPECT_EQ(replay.run->options().logs[1].offset, replay.run->begin() - at(5000));
  ASSERT_TRUE(replay.run->setOffsets({{later, 0ms}}).empty());
  const Replay chosen{ReplayOptions(replay.run->options())};
  ASSERT_TRUE(chosen.run);
  EXPECT_EQ(chosen.run->end(), at(5001)) << "what a person chose is kept";
}

TEST(ReplayRun, whatIsNoLogIsRefused) {
  EXPECT_EQ(Replay(replayOf({})).errors.front().id, "replay.no-log");
  const Replay missing(std::filesystem::path("/no/such.mcap"));
  ASSERT_FALSE(missing.run);
  EXPECT_THAT(robotlink::describe(missing.errors), HasSubstr("/no/such.mcap"));
}
