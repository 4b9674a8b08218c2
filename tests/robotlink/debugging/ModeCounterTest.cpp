// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ModeCounter.h"

#include <gtest/gtest.h>

#include <string>

namespace robotlink {
namespace {

using robotcontrol::KeyMode;
using namespace std::chrono_literals;

ModeCounter counter(KeyMode::Kind kind, std::uint32_t count) {
  KeyMode mode;
  mode.set_kind(kind);
  mode.set_n(count);
  ModeCounter result;
  result.set(mode);
  return result;
}

/// One letter for each use, 10 ms apart: x if it is due.
std::string uses(ModeCounter& counter, int count, Instant from = Instant(1s)) {
  std::string text;
  for (int i = 0; i < count; ++i) text += counter.due(from + 10ms * i) ? 'x' : '.';
  return text;
}

TEST(ModeCounter, offIsNeverDueAndAlwaysIsEachTime) {
  ModeCounter fresh;
  EXPECT_EQ(uses(fresh, 3), "...");
  auto off = counter(KeyMode::OFF, 3);
  EXPECT_EQ(uses(off, 3), "...");
  EXPECT_EQ(off.mode().n(), 0U);
  auto always = counter(KeyMode::ALWAYS, 3);
  EXPECT_EQ(uses(always, 3), "xxx");
  EXPECT_EQ(always.mode().n(), 0U);
}

TEST(ModeCounter, nTimesSwitchesItselfOffAndRemembersHowOften) {
  auto times = counter(KeyMode::N_TIMES, 2);
  EXPECT_EQ(uses(times, 5), "xx...");
  EXPECT_EQ(times.mode().kind(), KeyMode::OFF);
  EXPECT_EQ(times.mode().n(), 2U);
}

TEST(ModeCounter, zeroTimesIsOff) {
  auto never = counter(KeyMode::N_TIMES, 0);
  EXPECT_EQ(never.mode().kind(), KeyMode::OFF);
  EXPECT_EQ(uses(never, 3), "...");
}

TEST(ModeCounter, everyNthIsDue) {
  auto third = counter(KeyMode::EVERY_N, 3);
  EXPECT_EQ(uses(third, 7), "..x..x.");
  auto each = counter(KeyMode::EVERY_N, 1);
  EXPECT_EQ(uses(each, 3), "xxx");
}

TEST(ModeCounter, aModeThatIsSetAgainCountsFromTheStart) {
  auto third = counter(KeyMode::EVERY_N, 3);
  EXPECT_EQ(uses(third, 2), "..");
  third.set(third.mode());
  EXPECT_EQ(uses(third, 3), "..x");
}

TEST(ModeCounter, everyMillisecondsIsDueAtOnceAndThenNotBeforeThatTime) {
  auto every = counter(KeyMode::EVERY_MS, 25);
  EXPECT_EQ(uses(every, 7), "x..x..x");
  EXPECT_EQ(uses(every, 1, Instant(1s + 85ms)), "x") << "exactly 25 ms after the last one";
}

TEST(ModeCounter, aClockThatIsResetDoesNotSilenceIt) {
  auto every = counter(KeyMode::EVERY_MS, 1000);
  EXPECT_TRUE(every.due(Instant(500s)));
  EXPECT_TRUE(every.due(Instant(1s))) << "the simulation was reset";
  EXPECT_FALSE(every.due(Instant(1s + 999ms)));
  EXPECT_TRUE(every.due(Instant(2s)));
}

TEST(ModeCounter, theFirstUseAtTimeZeroIsDue) {
  auto every = counter(KeyMode::EVERY_MS, 100);
  EXPECT_TRUE(every.due(Instant{}));
  EXPECT_FALSE(every.due(Instant(99ms)));
}

}  // namespace
}  // namespace robotlink
