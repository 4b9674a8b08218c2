// SPDX-License-Identifier: GPL-3.0-or-later
// The program of today on the log of a real robot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "foxglove/Image.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Perception.pb.h"
#include "tests/app/ReplayFixture.h"

using namespace app;
using namespace app::testing;
using namespace std::chrono_literals;
using robotcontrol::ControlReplay;
using ::testing::HasSubstr;

namespace {

class RealLogReplay : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(realLog())) GTEST_SKIP() << "needs " << realLog();
  }
  static ReplayOptions options() {
    ReplayOptions options = replayOf({{realLog()}});
    options.colorTable = ROBOTCONTROL_SOURCE_DIR "/../shared/data/colour/bhuman2009/tables/default.c64";
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

/// Some streams of the real log left out.
void copyWithout(const std::set<std::string>& streams, const std::filesystem::path& to) {
  const auto log = logplayer::LogFile::open(realLog(), {});
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

TEST_F(RealLogReplay, perceptionIsRecomputedOnTheLoggedImagesAndPoses) {
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
  EXPECT_EQ(replay.countOn("nao/camera/image"), 160U);
  EXPECT_EQ(replay.countOn("nao/percepts/ball"), 160U);
  EXPECT_EQ(replay.countOn("nao/models/ball"), 160U);
}

/// As if the robot had told less of itself.
TEST_F(RealLogReplay, tasksThatLackInputsAreListedAndShownWithTheReason) {
  const auto folder = logplayer::TemporaryFolder::make();
  ReplayOptions compact = options();
  compact.logs = {{folder->path() / "less.mcap"}};
  compact.layout = robotlink::resource("layouts/compact.yaml");
  copyWithout({"nao/joints/states", "nao/camera/pose"}, compact.logs[0].file);
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
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(replay.run->step());
  EXPECT_GT(replay.countOn("nao/percepts/regions"), 3U) << "what has its inputs runs";
  EXPECT_EQ(replay.countOn("nao/percepts/ball"), 0U);
}

TEST_F(RealLogReplay, theFirstFrameShowsAtOnceWithWhatIsComputedOnIt) {
  Replay replay(options());
  ASSERT_TRUE(replay.run);
  EXPECT_TRUE(replay.reported.empty());
  // The log begins with joint angles.
  const auto first = replay.run->frameTime(replay.run->stepProcess(), 0);
  EXPECT_EQ(first, at(486.749));
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

TEST_F(RealLogReplay, theSameTwiceGivesTheSameBytesAndAnotherSolutionOthers) {
  const auto bytesWith = [](const std::string& solution) {
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

TEST_F(RealLogReplay, steppingBackShowsTheFrameBefore) {
  Replay replay(options());
  ASSERT_TRUE(replay.run->jump(*replay.run->timeOfFrame("nao/cognition", 100)).empty());
  EXPECT_EQ(replay.status().frame(), 100U);
  const auto back = replay.run->frameTime("nao/cognition", -1);
  ASSERT_TRUE(back);
  replay.reported.clear();
  ASSERT_TRUE(replay.run->jump(*back).empty());
  EXPECT_EQ(replay.status().frame(), 99U);
  EXPECT_EQ(replay.countOn("nao/camera/image"), 1U);
  EXPECT_EQ(replay.lastOn("nao/camera/image")->time, *back);
  EXPECT_EQ(replay.lastOn("nao/percepts/ball")->time, *back);
  // The same place, the same bytes.
  const std::string once = replay.digestOn("nao/models/ball");
  replay.reported.clear();
  ASSERT_TRUE(replay.run->jump(*back).empty());
  EXPECT_EQ(replay.digestOn("nao/models/ball"), once);
}
