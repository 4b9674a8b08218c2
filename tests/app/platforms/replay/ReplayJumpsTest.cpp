// SPDX-License-Identifier: GPL-3.0-or-later
// How a ReplayRun moves, or stays where it is, on logs that are written for that.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Scene.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/app/platforms/replay/ReplayFixture.h"

using namespace app;
using namespace app::test;
using namespace std::chrono_literals;
using robotcontrol::ControlReplay;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace {

const std::string kRecomputed = "red1/percepts/regions";

/// Short logs of single streams, and one of the simulated robot that is recorded once for all tests.
class ReplayJumps : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    recorded_ = std::make_unique<TestFolder>();
    recordSimulation(*recorded_ / "sim.mcap", "compact", 150);
  }
  static void TearDownTestSuite() { recorded_.reset(); }

  /// Writes a log with messages on one stream.
  std::filesystem::path write(const std::string& name, const std::string& stream,
                              const std::shared_ptr<google::protobuf::Message>& value,
                              const std::vector<double>& times) {
    const auto file = folder_ / name;
    auto writer = logplayer::LogWriter::create(file, {});
    for (const double time : times) EXPECT_TRUE((*writer)->write({{stream, at(time), value}}));
    return file;
  }
  std::filesystem::path writePlot(const std::string& name, const std::vector<double>& times) {
    return write(name, "red1/plots/a", std::make_shared<robotcontrol::PlotValue>(), times);
  }
  /// A layout in a file that breakLayout() makes useless.
  std::filesystem::path layoutFile() {
    const auto file = folder_ / "layout.yaml";
    std::filesystem::copy_file(robotlink::resource("layouts/compact.yaml"), file);
    return file;
  }
  void breakLayout() { std::ofstream(folder_ / "layout.yaml") << "version: 1\nname: broken\n"; }
  static std::filesystem::path simulation() { return *recorded_ / "sim.mcap"; }
  /// The robots see what is logged with the layout of layoutFile().
  ReplayOptions withLayout() {
    ReplayOptions options = replayOf({{simulation()}});
    options.layout = layoutFile();
    options.packages[kRecomputed] = ControlReplay::RECOMPUTED;
    options.publishAllPackages = true;
    return options;
  }
  static std::string differencesOf(const Replay& replay) {
    std::string all;
    const auto status = replay.status();
    for (const auto& row : status.differences()) all += row.ShortDebugString() + "\n";
    return all;
  }

  const TestFolder folder_;
  static inline std::unique_ptr<TestFolder> recorded_;
};

}  // namespace

TEST_F(ReplayJumps, aStreamOfTheWorldIsFoundInAnyLogThatPublishesIt) {
  const auto plots = writePlot("plots.mcap", {0, 2});
  const auto world =
      write("world.mcap", "transforms", std::make_shared<foxglove::FrameTransforms>(), {0.5, 1, 1.5});
  Replay replay(replayOf({{plots}, {world, 100ms}}));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  EXPECT_EQ(replay.run->firstTime("transforms"), at(0.6));
  EXPECT_EQ(replay.run->messageTime("transforms", 2), at(1.1));
  EXPECT_EQ(replay.run->messageTime("map", 1), std::nullopt);
}

TEST_F(ReplayJumps, afterALogWithASceneTheWorldOfOthersIsNotPublished) {
  const auto scene = write("scene.mcap", "scene", std::make_shared<foxglove::SceneUpdate>(), {0});
  const auto world =
      write("world.mcap", "transforms", std::make_shared<foxglove::FrameTransforms>(), {0.5, 1});
  Replay replay(replayOf({{scene}, {world}}));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  EXPECT_EQ(replay.run->firstTime("transforms"), std::nullopt);
  EXPECT_EQ(replay.run->firstTime("scene"), at(0));
}

TEST_F(ReplayJumps, severalMessagesAtOneInstantAreOneStep) {
  Replay replay(replayOf({{writePlot("plots.mcap", {1, 1, 2, 3, 3, 3})}}));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  const auto stepped = [&](double from, int count) {
    EXPECT_TRUE(replay.run->jump(at(from)).empty());
    return replay.run->messageTime("red1/plots/a", count);
  };
  EXPECT_EQ(stepped(1, 0), at(1));
  EXPECT_EQ(stepped(1, 1), at(2));
  EXPECT_EQ(stepped(1, 2), at(3));
  EXPECT_EQ(stepped(1, 99), at(3)) << "the last one";
  EXPECT_EQ(stepped(1, -1), at(1)) << "the first one";
  EXPECT_EQ(stepped(2.5, 0), at(2));
  EXPECT_EQ(stepped(2.5, 1), at(3));
  EXPECT_EQ(stepped(2.5, -1), at(1));
  EXPECT_EQ(stepped(3, 1), at(3));
  EXPECT_EQ(stepped(3, -1), at(2));
  EXPECT_EQ(stepped(3, -2), at(1));
  EXPECT_EQ(stepped(3, std::numeric_limits<int>::min()), at(1));
  EXPECT_EQ(replay.run->firstTime("red1/plots/a"), at(1));
}

TEST_F(ReplayJumps, aJumpThatFailsLeavesTheLogWhereItWas) {
  Replay replay(withLayout());
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  ASSERT_TRUE(replay.run->jump(at(0.8)).empty());
  breakLayout();
  replay.reported.clear();
  const auto errors = replay.run->jump(at(0.2));
  ASSERT_FALSE(errors.empty());
  EXPECT_THAT(robotlink::describe(errors), HasSubstr("layout.yaml"));
  EXPECT_EQ(replay.run->now(), at(0.8));
  EXPECT_THAT(replay.reported, IsEmpty());
  ASSERT_TRUE(replay.run->step());
  EXPECT_EQ(replay.run->now(), at(0.808)) << "it is played on from there";
  replay.playToEnd();
  EXPECT_GT(replay.countOn(kRecomputed), 5U) << "by the program that it had";
}

TEST_F(ReplayJumps, anOffsetThatCannotBeSetIsReportedAndTheOneBeforeStays) {
  Replay replay(withLayout());
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  ASSERT_TRUE(replay.run->setOffsets({{simulation(), 100ms}}).empty());
  EXPECT_EQ(replay.run->end(), at(1.3));
  breakLayout();
  EXPECT_THAT(robotlink::describe(replay.run->setOffsets({{simulation(), 5s}})), HasSubstr("layout.yaml"));
  EXPECT_EQ(replay.run->end(), at(1.3));
  EXPECT_EQ(replay.run->options().logs[0].offset, 100ms);
  EXPECT_EQ(replay.status().logs(0).offset(), robotlink::Duration(100ms).count());
}

TEST_F(ReplayJumps, choicesThatAreRefusedKeepTheDifferencesOfAllRobots) {
  ReplayOptions options = replayOf({{simulation()}, {simulation(), 8ms}});
  options.packages["*/percepts/regions"] = ControlReplay::RECOMPUTED;
  Replay replay(options);
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  replay.playToEnd();
  const std::string before = differencesOf(replay);
  ASSERT_THAT(before, HasSubstr("red1-2/percepts/regions"));
  const auto now = replay.run->now();
  replay.reported.clear();
  const auto refused = replay.run->choosePackages(
      {{kRecomputed, ControlReplay::AS_LOGGED}, {"red1-2/camera/image", ControlReplay::RECOMPUTED}});
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].id, "replay.cannot-recompute");
  EXPECT_EQ(differencesOf(replay), before);
  EXPECT_EQ(replay.run->now(), now);
  EXPECT_THAT(replay.reported, IsEmpty());
  EXPECT_THAT(recomputedPackages(replay.status()),
              ::testing::ElementsAre(kRecomputed, "red1-2/percepts/regions"));
  ASSERT_TRUE(replay.run->choosePackages({{kRecomputed, ControlReplay::AS_LOGGED}}).empty());
  EXPECT_NE(differencesOf(replay), before) << "those of other programs are not compared any more";
}

TEST_F(ReplayJumps, parametersOfTheActiveSolutionAreKept) {
  Replay replay(recomputingAll(simulation()));
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  const auto values = [&] {
    const auto* message = replay.lastOn("red1/parameters/ball-model/last-percept");
    return message == nullptr ? nullptr
                              : dynamic_cast<const robotcontrol::ParameterValues*>(message->value.get());
  };
  robotcontrol::Request request = selectRequest("red1", "ball-model", "last-percept");
  request.set_id(1);
  ASSERT_TRUE(replay.run->request(request));
  request.mutable_get_parameters()->set_task("ball-model");
  ASSERT_TRUE(replay.run->request(request));
  for (int i = 0; i < 10; ++i) replay.run->step();
  ASSERT_NE(values(), nullptr);
  request.mutable_set_parameters()->set_task("ball-model");
  request.mutable_set_parameters()->mutable_value()->set_type(values()->value().type());
  // The first field, `memory`, as 0.125 s.
  const std::string data("\x09\0\0\0\0\0\0\xc0\x3f", 9);
  ASSERT_NE(values()->value().data(), data);
  request.mutable_set_parameters()->mutable_value()->set_data(data);
  request.set_id(2);
  ASSERT_TRUE(replay.run->request(request));
  for (int i = 0; i < 10; ++i) replay.run->step();
  EXPECT_EQ(values()->value().data(), data);
  ASSERT_TRUE(replay.run->jump(at(0.4)).empty());
  replay.reported.clear();
  request.mutable_get_parameters()->set_task("ball-model");
  request.mutable_get_parameters()->set_solution("last-percept");
  ASSERT_TRUE(replay.run->request(request));
  for (int i = 0; i < 10; ++i) replay.run->step();
  ASSERT_NE(values(), nullptr);
  EXPECT_EQ(values()->value().data(), data);
}

TEST_F(ReplayJumps, aRobotIsWhatTheLogSaysAtThatPlace) {
  const auto setup = [](const std::string& kind) {
    auto value = std::make_shared<robotcontrol::ProgramSetup>();
    value->mutable_layout()->set_name("layouts/none.yaml");
    value->mutable_layout()->set_text(
        "version: 1\nname: none\nprocesses: [{name: debug, debug: true, period_ms: 16}]\n");
    const auto text = robotlink::readFile(robotlink::resource("robots/" + kind + ".yaml"));
    value->mutable_description()->set_name("robots/" + kind + ".yaml");
    value->mutable_description()->set_text(text.value_or(""));
    return value;
  };
  const auto file = folder_ / "two.mcap";
  {
    auto writer = logplayer::LogWriter::create(file, {});
    for (const auto& [time, kind] : {std::pair(0, "ers210"), std::pair(5, "p3at"), std::pair(10, "p3at")})
      ASSERT_TRUE((*writer)->write({{"robot7/program", at(time), setup(kind)}}));
  }
  Replay replay(file);
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  EXPECT_EQ(replay.run->description("robot7")->name, "ers210");
  EXPECT_NE(replay.run->field()->name, "");
  ASSERT_TRUE(replay.run->jump(at(4.9)).empty());
  EXPECT_EQ(replay.run->description("robot7")->name, "ers210");
  ASSERT_TRUE(replay.run->jump(at(5.1)).empty());
  EXPECT_EQ(replay.run->description("robot7")->name, "p3at") << "though the jump begins before";
  EXPECT_EQ(replay.run->field()->name, "") << "a Pioneer has none";
  ASSERT_TRUE(replay.run->jump(at(0)).empty());
  EXPECT_EQ(replay.run->description("robot7")->name, "ers210");
}
