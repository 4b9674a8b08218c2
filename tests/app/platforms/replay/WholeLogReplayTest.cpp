// SPDX-License-Identifier: GPL-3.0-or-later
// The program of today on whole logs of 2009: that of a real robot, and one that was made up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "foxglove/Image.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Perception.pb.h"
#include "tests/app/platforms/replay/ReplayFixture.h"
#include "tests/game/Data.h"
#include "tests/game/Log.h"

using namespace app;
using namespace app::test;
using namespace std::chrono_literals;
using robotcontrol::ControlReplay;
using ::testing::HasSubstr;

namespace {

/// What is known of a log.
struct Figures {
  std::size_t images = 0;
  Instant firstImage;
  /// A frame in the middle of it.
  std::uint64_t frame = 0;
};

/// The parameter is the source of the log.
class WholeLogReplay : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(log())) GTEST_SKIP() << "the real log is not at " << log();
  }
  std::filesystem::path log() const { return game::dataOf(GetParam()) / "logs/bhuman2009.log"; }
  Figures expected() const {
    if (GetParam() == "real") return {160, at(486.749), 100};
    return {game::View::kCount, game::Log::imageTime(0), 8};
  }
  ReplayOptions options() const {
    ReplayOptions options = replayOf({{log()}});
    options.colorTable = (game::dataOf(GetParam()) / "colour/bhuman2009/tables/default.c64").string();
    options.publishAllPackages = true;
    return options;
  }
};

ControlReplay::PackageSource sourceOf(const robotcontrol::ReplayStatus& status, const std::string& name) {
  for (const auto& package : status.packages()) {
    if (package.package() == name) return package.source();
  }
  return ControlReplay::AUTOMATIC;
}

/// Copies a log, with some of its streams left out.
void copyWithout(const std::set<std::string>& streams, const std::filesystem::path& from,
                 const std::filesystem::path& to) {
  const auto log = logplayer::LogFile::open(from, {});
  ASSERT_TRUE(log.has_value());
  const auto writer = logplayer::LogWriter::create(to, {});
  ASSERT_TRUE(writer.has_value());
  logplayer::LogFile::Cursor cursor(*log, {});
  while (const auto message = cursor.next()) {
    if (streams.contains(message->path)) continue;
    ASSERT_TRUE((*writer)->write({*message}).has_value());
  }
}

}  // namespace

TEST_P(WholeLogReplay, perceptionIsRecomputedOnTheLoggedImagesAndPoses) {
  Replay replay(options());
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  const auto status = replay.status();
  for (const char* logged : {"nao/camera/image", "nao/camera/pose", "nao/joints/states"}) {
    EXPECT_EQ(sourceOf(status, logged), ControlReplay::AS_LOGGED) << logged;
  }
  for (const char* recomputed : {"nao/percepts/regions", "nao/percepts/ball", "nao/models/ball"}) {
    EXPECT_EQ(sourceOf(status, recomputed), ControlReplay::RECOMPUTED) << recomputed;
  }
  EXPECT_EQ(replay.run->stepProcess(), "nao/cognition");
  EXPECT_TRUE(status.logs(0).read_only());
  EXPECT_EQ(replay.run->description("nao")->name, "nao");
  replay.playToEnd();
  EXPECT_TRUE(replay.troubles.empty()) << replay.troubles.front();
  EXPECT_EQ(replay.countOn("nao/camera/image"), expected().images);
  EXPECT_EQ(replay.countOn("nao/percepts/ball"), expected().images);
  EXPECT_EQ(replay.countOn("nao/models/ball"), expected().images);
}

/// As if the robot had told less of itself.
TEST_P(WholeLogReplay, tasksThatLackInputsAreListedAndShownWithTheReason) {
  const TestFolder folder;
  ReplayOptions compact = options();
  compact.logs = {{folder / "less.mcap"}};
  compact.layout = robotlink::resource("layouts/compact.yaml");
  copyWithout({"nao/joints/states", "nao/camera/pose"}, log(), compact.logs[0].file);
  Replay replay(compact);
  ASSERT_TRUE(replay.run) << robotlink::describe(replay.errors);
  ASSERT_TRUE(replay.run->jump(replay.run->begin()).empty());
  const auto status = replay.status();
  const auto& unavailable = status.unavailable_tasks();
  EXPECT_THAT(
      unavailable,
      ::testing::Contains(
          "nao/camera-pose: neither the robot nor another task provides joint angles (joints/states)"));
  EXPECT_THAT(
      unavailable,
      ::testing::Contains(
          "nao/ball-percept: neither the robot nor another task provides the camera's pose (camera/pose)"));
  EXPECT_THAT(unavailable,
              ::testing::Contains(
                  "nao/motion: neither the robot nor another task provides joint angles (joints/states)"));
  const auto* reported = replay.lastOn("nao/tables/solutions");
  ASSERT_NE(reported, nullptr);
  const auto& table = dynamic_cast<const robotcontrol::SolutionTable&>(*reported->value);
  for (const std::string& text : unavailable) {
    const std::string task = text.substr(4, text.find(':') - 4);
    const auto row = std::find_if(table.tasks().begin(), table.tasks().end(),
                                  [&](const auto& r) { return r.name() == task; });
    ASSERT_NE(row, table.tasks().end()) << task;
    EXPECT_EQ(row->active(), "");
    for (const auto& solution : row->solutions())
      EXPECT_THAT(solution.unavailable(), HasSubstr("unavailable because "));
  }
  for (int i = 0; i < 20 && replay.run->step(); ++i) {
  }
  EXPECT_GT(replay.countOn("nao/percepts/regions"), 3U) << "what has its inputs runs";
  EXPECT_EQ(replay.countOn("nao/percepts/ball"), 0U);
}

TEST_P(WholeLogReplay, theFirstFrameShowsAtOnceWithWhatIsComputedOnIt) {
  Replay replay(options());
  ASSERT_TRUE(replay.run);
  EXPECT_TRUE(replay.reported.empty());
  // The log begins with joint angles.
  const auto first = replay.run->frameTime(replay.run->stepProcess(), 0);
  EXPECT_EQ(first, expected().firstImage);
  ASSERT_TRUE(replay.run->jump(*first).empty());
  const auto* image = replay.lastOn("nao/camera/image");
  ASSERT_NE(image, nullptr);
  EXPECT_EQ(image->time, *first);
  const auto* raw = dynamic_cast<const foxglove::RawImage*>(image->value.get());
  ASSERT_NE(raw, nullptr) << "it is told as a camera would";
  EXPECT_EQ(raw->width(), 320U);
  ASSERT_NE(replay.lastOn("nao/percepts/regions"), nullptr);
  EXPECT_EQ(replay.lastOn("nao/percepts/regions")->time, *first);
}

TEST_P(WholeLogReplay, theSameTwiceGivesTheSameBytesAndAnotherSolutionOthers) {
  const auto bytesWith = [this](const std::string& solution) {
    ReplayOptions overrides = options();
    if (!solution.empty()) overrides.solutions["ball-percept"] = solution;
    Replay replay(overrides);
    replay.playToEnd();
    return replay.digestOn("nao/percepts/ball") + replay.digestOn("nao/models/ball");
  };
  const std::string first = bytesWith("");
  EXPECT_EQ(first, bytesWith(""));
  EXPECT_NE(first, bytesWith("circle-fit"));
}

TEST_P(WholeLogReplay, steppingBackShowsTheFrameBefore) {
  Replay replay(options());
  ASSERT_TRUE(replay.run->jump(*replay.run->timeOfFrame("nao/cognition", expected().frame)).empty());
  EXPECT_EQ(replay.status().frame(), expected().frame);
  const auto back = replay.run->frameTime("nao/cognition", -1);
  ASSERT_TRUE(back);
  replay.reported.clear();
  ASSERT_TRUE(replay.run->jump(*back).empty());
  EXPECT_EQ(replay.status().frame(), expected().frame - 1);
  EXPECT_EQ(replay.countOn("nao/camera/image"), 1U);
  EXPECT_EQ(replay.lastOn("nao/camera/image")->time, *back);
  EXPECT_EQ(replay.lastOn("nao/percepts/ball")->time, *back);
  // The same place, the same bytes.
  const std::string once = replay.digestOn("nao/models/ball");
  replay.reported.clear();
  ASSERT_TRUE(replay.run->jump(*back).empty());
  EXPECT_EQ(replay.digestOn("nao/models/ball"), once);
}

INSTANTIATE_TEST_SUITE_P(Logs, WholeLogReplay, ::testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });
