// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayComputation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "logplayer/search/LogSearch.h"
#include "robotcontrol/Modeling.pb.h"
#include "tests/app/platforms/replay/ReplayFixture.h"
#include "tests/game/Log.h"

using namespace app;
using namespace app::test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace {

constexpr char kBall[] = "nao/models/ball";

/// From when until when something is true; the end of the log is no end.
using Span = std::pair<Instant, std::optional<Instant>>;

/// A whole log in the format of 2009, made up. It holds images, poses and joints, but nothing of what the
/// program makes of them.
class ReplayComputationTest : public ::testing::Test {
 protected:
  ReplayComputationTest() {
    game::Log::write(file());
    log = *logplayer::LogFile::open(file(), {});
  }
  std::filesystem::path file() const { return folder / "game.log"; }
  /// What is found; fails with the reason if nothing can be searched.
  std::vector<Span> search(const std::string& expression, const ComputationOptions& options = {}) {
    std::vector<Span> spans;
    auto done = logplayer::searchLog(log, expression, {},
                                     [&](const logplayer::SearchHit& hit) {
                                       spans.emplace_back(hit.from, hit.until);
                                       return true;
                                     },
                                     {computationByReplay(options)});
    EXPECT_TRUE(done) << done.error().describe();
    if (done) report = *done;
    return spans;
  }
  /// When the ball is known in a replay that publishes everything.
  std::vector<Span> spansOfReplay(ReplayOptions options) const {
    options.publishAllPackages = true;
    Replay replay(options);
    replay.playToEnd();
    std::vector<Span> spans;
    for (const StreamMessage& message : replay.reported) {
      if (message.path != kBall) continue;
      const bool isKnown = dynamic_cast<const robotcontrol::BallModel&>(*message.value).known();
      const bool wasKnown = !spans.empty() && !spans.back().second;
      if (isKnown && !wasKnown) spans.emplace_back(message.time, std::nullopt);
      if (!isKnown && wasKnown) spans.back().second = message.time;
    }
    return spans;
  }

  const TestFolder folder;
  std::shared_ptr<logplayer::LogFile> log;
  logplayer::SearchReport report;
};

}  // namespace

TEST_F(ReplayComputationTest, whatTheProgramComputesIsFoundAsInAReplay) {
  EXPECT_EQ(search("models/ball.known"), spansOfReplay(replayOf({{file()}})));
  EXPECT_THAT(report.computed, ElementsAre(kBall));
  EXPECT_THAT(report.losses, IsEmpty());
  EXPECT_EQ(search("nao/models/ball.known >= 0"), (std::vector<Span>{{game::Log::imageTime(0), {}}}))
      << "from its first message on";
}

TEST_F(ReplayComputationTest, aChosenSolutionComputesIt) {
  ReplayOptions options = replayOf({{file()}});
  options.solutions = {{"ball-model", "last-percept"}};
  EXPECT_EQ(search("models/ball.known", {.solutions = options.solutions}), spansOfReplay(options));
  const auto wrong = computationByReplay({.solutions = {{"ball-model", "nobody"}}})(log);
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().text, HasSubstr("nobody"));
}

TEST_F(ReplayComputationTest, onlyWhatTheLogLacksCanBeComputed) {
  const auto made = computationByReplay()(log);
  ASSERT_TRUE(made) << made.error().describe();
  EXPECT_THAT((*made)->streams(), Contains(kBall));
  EXPECT_THAT((*made)->streams(), Not(Contains("nao/camera/image")));
}

TEST_F(ReplayComputationTest, itEndsInTheMiddle) {
  int asked = 0;
  const auto canceled =
      logplayer::searchLog(log, "models/ball.known", {.progress = [&](double) { return ++asked < 5; }},
                           [](const logplayer::SearchHit&) { return true; }, {computationByReplay()});
  ASSERT_FALSE(canceled);
  EXPECT_EQ(canceled.error().id, "log.given-up");
  EXPECT_EQ(asked, 5);
}
