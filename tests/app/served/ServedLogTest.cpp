// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <filesystem>

#include "app/platforms/replay/ReplayFeed.h"
#include "tests/app/ShortLog.h"
#include "tests/app/served/ServedTest.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotlink::websocket::PlaybackControl;
using robotlink::websocket::PlaybackState;
using robotlink::websocket::ServerInfo;
using test::ShortLog;
using testing::Contains;
using Phase = PlaybackState::Phase;
using Command = PlaybackControl::Command;

PlatformOpening openingOfShortLog(const std::filesystem::path& file) {
  if (const std::string wrong = ShortLog::write(file); !wrong.empty()) throw std::runtime_error(wrong);
  ReplayOptions options;
  options.logs.push_back({file});
  return ReplayFeed::opening(std::move(options));
}

/// A served log, which is played at first. It can be asked for from when the server knows its range of time.
class ServedLogTest : public test::ServedTest {
 protected:
  ServedLogTest()
      : ServedTest(openingOfShortLog(testing::TempDir() + "served_log.mcap")),
        info_(expect<ServerInfo>([](const auto& said) { return said.dataStart.has_value(); })) {}
  /// Sends what the client wants, and returns the answer.
  PlaybackState control(const PlaybackControl& wanted) {
    client_->send(wanted);
    return expect<PlaybackState>([&](const auto& state) { return state.requestId == wanted.requestId; });
  }

  const ServerInfo info_;
};

TEST_F(ServedLogTest, clientsKnowItsRangeOfTime) {
  EXPECT_THAT(info_.capabilities, Contains("playbackControl"));
  EXPECT_EQ(info_.dataStart, ShortLog::time(0));
  EXPECT_EQ(info_.dataEnd, ShortLog::time(ShortLog::kFrames - 1));
}

TEST_F(ServedLogTest, aClientMovesTheLogPlayer) {
  const PlaybackState paused = control({Command::kPause, 0.5F, ShortLog::time(5), "a"});
  EXPECT_EQ(paused.phase, Phase::kPaused);
  EXPECT_EQ(paused.time, ShortLog::time(5));
  EXPECT_EQ(paused.speed, 0.5F);
  EXPECT_TRUE(paused.didSeek);
  const PlaybackState playing = control({Command::kPlay, 50, {}, "b"});
  EXPECT_EQ(playing.phase, Phase::kPlaying);
  EXPECT_EQ(playing.speed, 50);
  EXPECT_FALSE(playing.didSeek);
  const auto ended = expect<PlaybackState>([](const auto& state) { return state.phase == Phase::kEnded; });
  EXPECT_EQ(ended.time, ShortLog::time(ShortLog::kFrames - 1));
}

TEST_F(ServedLogTest, aSpeedThatTheLogDoesNotHaveIsRefusedWithAReason) {
  control({Command::kPause, 1, {}, "a"});
  client_->send(PlaybackControl{Command::kPlay, -3, {}, "b"});
  EXPECT_THAT(expect<robotlink::websocket::Status>().message, testing::HasSubstr("speed"));
  EXPECT_EQ(expect<PlaybackState>([](const auto& state) { return state.requestId == "b"; }).phase,
            Phase::kPaused);
}

}  // namespace
}  // namespace app
