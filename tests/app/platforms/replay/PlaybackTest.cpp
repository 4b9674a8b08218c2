// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/Playback.h"

#include <gtest/gtest.h>

#include "robotlink/debugging/RequestKinds.h"

#include <vector>

using namespace app;
using namespace std::chrono_literals;
using What = Playback::Next::What;

namespace {

using robotlink::Instant;
using Real = Playback::RealTime;

Instant playbackAt(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

/// A log of which only the times of its messages are known, played in a real time that a test turns.
struct Player {
  explicit Player(std::vector<double> times) {
    for (const double time : times) log.push_back(playbackAt(time));
  }
  Playback::Place place() const {
    Playback::Place place{log[index], log.front(), log.back(), std::nullopt};
    if (index + 1 < log.size()) place.next = log[index + 1];
    return place;
  }
  void jump(Instant time) {
    index = 0;
    while (index + 1 < log.size() && log[index + 1] <= time) ++index;
    playback.jumped(real, place());
  }
  void play() { playback.play(real, place()); }
  /// Does what is due; what was done, in real milliseconds since the start: "40 step 1.04".
  std::vector<std::string> run(std::chrono::milliseconds duration) {
    std::vector<std::string> done;
    const Real end = real + duration;
    while (const auto next = playback.next(place())) {
      if (next->due > end) break;
      real = std::max(real, next->due);
      const auto since = std::chrono::round<std::chrono::milliseconds>(real - start).count();
      done.push_back(std::to_string(since) + " " + carryOut(*next));
    }
    real = end;
    return done;
  }
  std::string carryOut(const Playback::Next& next) {
    if (next.what == What::kPause) {
      playback.pause();
      return "pause";
    }
    if (next.what == What::kJump) {
      jump(next.to);
      return "jump " + std::to_string(index);
    }
    playback.stepping(real, place());
    ++index;
    return "step " + std::to_string(index);
  }

  std::vector<Instant> log;
  std::size_t index = 0;
  const Real start{1h};
  Real real = start;
  Playback playback;
};

using Done = std::vector<std::string>;

}  // namespace

TEST(Playback, itIsPlayedInRealTimeAndPausesAtTheEnd) {
  Player player({486, 486.1, 486.3});
  EXPECT_EQ(player.run(1000ms), Done{}) << "paused";
  player.real = player.start;
  player.play();
  EXPECT_EQ(player.run(1000ms), (Done{"100 step 1", "300 step 2", "300 pause"}));
  EXPECT_FALSE(player.playback.playing());
}

TEST(Playback, itIsPlayedSlowlyAndFast) {
  for (const double speed : {robotlink::kReplaySpeeds.min, robotlink::kReplaySpeeds.max}) {
    Player player({0, 1});
    player.playback.setSpeed(speed, player.real, player.place());
    player.play();
    const int ms = static_cast<int>(1000 / speed);
    EXPECT_EQ(player.run(30s), (Done{std::to_string(ms) + " step 1", std::to_string(ms) + " pause"}));
  }
}

TEST(Playback, theSpeedChangesFromWhereOneIs) {
  Player player({0, 1});
  player.play();
  player.run(500ms);
  player.playback.setSpeed(0.5, player.real, player.place());
  EXPECT_EQ(player.playback.reached(player.real, player.place()), playbackAt(0.5));
  EXPECT_EQ(player.run(2s), (Done{"1500 step 1", "1500 pause"}));
}

TEST(Playback, afterAPauseItGoesOnFromWhereItStood) {
  Player player({0, 1, 2});
  player.play();
  EXPECT_EQ(player.run(1500ms), Done{"1000 step 1"});
  player.playback.pause();
  EXPECT_EQ(player.run(10s), Done{});
  player.play();
  EXPECT_EQ(player.run(2s), (Done{"12500 step 2", "12500 pause"}));
}

TEST(Playback, whoWasHeldUpDoesNotCatchUp) {
  Player player({0, 0.1, 0.2, 0.3});
  player.play();
  player.run(100ms);
  player.real += 1h;  // a breakpoint
  EXPECT_EQ(player.run(1s), (Done{"3600100 step 2", "3600200 step 3", "3600200 pause"}));
}

TEST(Playback, gapsAreWaitedForOrSkipped) {
  const std::vector<double> times{0, 0.5, 10, 10.5};
  Player waits(times);
  waits.play();
  EXPECT_EQ(waits.run(20s), (Done{"500 step 1", "10000 step 2", "10500 step 3", "10500 pause"}));
  Player skips(times);
  skips.playback.setSkipsGaps(true);
  skips.play();
  EXPECT_EQ(skips.run(20s), (Done{"500 step 1", "500 step 2", "1000 step 3", "1000 pause"}));
}

TEST(Playback, allIsPlayedInALoop) {
  Player player({0, 0.2, 0.4});
  player.playback.setLoop(true);
  player.play();
  EXPECT_EQ(player.run(900ms),
            (Done{"200 step 1", "400 step 2", "400 jump 0", "600 step 1", "800 step 2", "800 jump 0"}));
}

TEST(Playback, aRangeIsPlayedInALoopToItsEnd) {
  Player player({0, 0.2, 0.4, 0.6, 0.8});
  player.playback.setLoop(true);
  player.playback.setRange(Playback::Range{playbackAt(0.2), playbackAt(0.5)});
  player.jump(playbackAt(0.2));
  player.play();
  EXPECT_EQ(player.run(700ms), (Done{"200 step 2", "300 jump 1", "500 step 2", "600 jump 1"}));
}

TEST(Playback, fromOutsideARangeTheLoopGoesToItsStart) {
  for (const double from : {0.0, 0.8}) {
    Player player({0, 0.2, 0.4, 0.6, 0.8});
    player.playback.setLoop(true);
    player.playback.setRange(Playback::Range{playbackAt(0.2), playbackAt(0.4)});
    player.jump(playbackAt(from));
    player.play();
    const Done done = player.run(150ms);
    ASSERT_EQ(done.size(), 1U);
    EXPECT_EQ(done[0], "100 jump 1");
  }
}

TEST(Playback, aRangeMayBeginBetweenMessages) {
  Player player({0, 0.2, 0.4, 0.6, 0.8});
  player.playback.setLoop(true);
  player.playback.setRange(Playback::Range{playbackAt(0.3), playbackAt(0.6)});
  player.jump(playbackAt(0.3));
  player.play();
  EXPECT_EQ(player.run(900ms),
            (Done{"200 step 2", "400 step 3", "400 jump 1", "600 step 2", "800 step 3", "800 jump 1"}));
}

TEST(Playback, aRangeWithoutALoopChangesNothing) {
  Player player({0, 0.2, 0.4});
  player.playback.setRange(Playback::Range{playbackAt(0), playbackAt(0.2)});
  player.play();
  EXPECT_EQ(player.run(1s), (Done{"200 step 1", "400 step 2", "400 pause"}));
}

TEST(Playback, aLoopOfNoLengthDoesNotSpin) {
  Player player({5});
  player.playback.setLoop(true);
  player.play();
  EXPECT_LE(player.run(1s).size(), 11U);
  Player between({0, 10});
  between.playback.setLoop(true);
  between.playback.setRange(Playback::Range{playbackAt(5), playbackAt(5.001)});
  between.play();
  EXPECT_LE(between.run(1s).size(), 11U);
}

TEST(Playback, betweenStepsTimeGoesOnButNotPastTheNext) {
  Player player({0, 1, 5});
  player.play();
  EXPECT_EQ(player.playback.reached(player.start + 400ms, player.place()), playbackAt(0.4));
  EXPECT_EQ(player.playback.reached(player.start + 5s, player.place()), playbackAt(1));
  player.playback.pause();
  EXPECT_EQ(player.playback.reached(player.start + 400ms, player.place()), playbackAt(0));
}
