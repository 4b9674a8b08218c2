// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions in the shadow of others while a log is replayed.
#include <gmock/gmock.h>

#include <set>

#include "robotcontrol/Modeling.pb.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "tests/app/platforms/replay/ReplayFixture.h"

using namespace app;
using namespace app::test;
using ::testing::HasSubstr;

namespace {

const std::vector<robotlink::ShadowName> kLastPercept{{"ball-model", "last-percept"}};
constexpr char kShadowedBall[] = "red1/models/ball", kShadowBall[] = "red1/shadow/last-percept/models/ball",
               kDrawing[] = "red1/drawings/robot/ball-model/ball",
               kShadowDrawing[] = "red1/shadow/last-percept/drawings/robot/ball-model/ball",
               kTimes[] = "red1/stopwatches/modeling";

class ReplayShadowTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TestFolder>();
    recordSimulation(file(), "balanced", 200);
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::filesystem::path file() { return *folder_ / "run.mcap"; }
  static ReplayOptions recomputing() {
    ReplayOptions options = replayOf({{file()}});
    options.packages["*/models/ball"] = robotcontrol::ControlReplay::RECOMPUTED;
    options.publishAllPackages = true;
    return options;
  }
  /// The names of solutions of the ball model that were timed.
  static std::set<std::string> timed(const Replay& replay) {
    std::set<std::string> names;
    for (const auto& message : replay.reported) {
      const auto* times = message.path == kTimes
                              ? dynamic_cast<const robotcontrol::StopwatchTimes*>(message.value.get())
                              : nullptr;
      for (int i = 0; times != nullptr && i < times->entries_size(); ++i)
        if (times->entries(i).task() == "ball-model") names.insert(times->entries(i).solution());
    }
    return names;
  }

 private:
  static inline std::unique_ptr<TestFolder> folder_;
};

TEST_F(ReplayShadowTest, whatItYieldsDrawsAndTakesStandsBesideTheActiveOne) {
  Replay alone(recomputing());
  ASSERT_TRUE(alone.run) << robotlink::describe(alone.errors);
  ASSERT_TRUE(alone.run->jump(alone.run->begin()).empty());
  alone.playToEnd();
  EXPECT_EQ(alone.countOn(kShadowBall), 0U);

  Replay shadowed(recomputing());
  ASSERT_TRUE(shadowed.run->runShadows(kLastPercept));
  for (const char* key : {"ball-model/ball", "timing/tasks"})
    ASSERT_TRUE(shadowed.run->request(keyRequest("red1", key)));
  ASSERT_TRUE(shadowed.run->jump(shadowed.run->begin()).empty());
  shadowed.playToEnd();
  EXPECT_GT(shadowed.countOn(kShadowBall), 20U);
  EXPECT_EQ(shadowed.countOn(kShadowBall), shadowed.countOn(kShadowedBall));
  EXPECT_NE(shadowed.digestOn(kShadowBall), shadowed.digestOn(kShadowedBall));
  EXPECT_GT(shadowed.countOn(kDrawing), 20U);
  EXPECT_GT(shadowed.countOn(kShadowDrawing), 20U);
  EXPECT_EQ(timed(shadowed), (std::set<std::string>{"kalman", "last-percept (shadow)"}));
  // Nothing that was computed without it is different.
  EXPECT_EQ(shadowed.digestOn(kShadowedBall), alone.digestOn(kShadowedBall));
  EXPECT_EQ(shadowed.status().differences(0).different(), 0U);
  EXPECT_TRUE(shadowed.troubles.empty());
}

TEST_F(ReplayShadowTest, itStaysOverJumpsAndGivesTheSameBytes) {
  Replay replay(recomputing());
  ASSERT_TRUE(replay.run->runShadows(kLastPercept));
  ASSERT_TRUE(replay.run->jump(replay.run->begin()).empty());
  replay.playToEnd();
  const std::string first = replay.digestOn(kShadowBall);
  replay.reported.clear();
  ASSERT_TRUE(replay.run->jump(replay.run->begin()).empty());
  replay.playToEnd();
  EXPECT_EQ(replay.digestOn(kShadowBall), first);
}

TEST_F(ReplayShadowTest, aTaskThatDoesNotRunHasNoShadow) {
  Replay asLogged(file());
  const auto done = asLogged.run->runShadows(kLastPercept);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text, HasSubstr("last-percept of ball-model cannot run in the shadow"));
  EXPECT_THAT(done.error().text, HasSubstr("--package"));
}

}  // namespace
