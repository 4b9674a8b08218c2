// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/TurnThread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/Eventually.h"

namespace app {
namespace {

using namespace std::chrono_literals;

const ModulePatience kLong(30s);

TEST(TurnThread, whoAsksForATurnGetsItsResultAtOnce) {
  int turns = 0;
  TurnThread thread([&] { ++turns; });
  for (int i = 1; i <= 100; ++i) {
    EXPECT_TRUE(thread.run(kLong));
    EXPECT_EQ(turns, i);
    EXPECT_FALSE(thread.isBusy());
  }
}

TEST(TurnThread, aTurnThatDoesNotReturnKeepsNobody) {
  std::atomic<bool> isReleased{false};
  TurnThread thread([&] { isReleased.wait(false); });
  EXPECT_FALSE(thread.run(ModulePatience(1ms)));
  EXPECT_TRUE(thread.isBusy());
  EXPECT_FALSE(thread.waitFor(1ms));
  isReleased = true;
  isReleased.notify_all();
  EXPECT_TRUE(thread.waitFor(30s));
  EXPECT_TRUE(thread.run(kLong));
}

TEST(TurnThread, makesTurnsInOneThreadOfItsOwn) {
  std::thread::id of;
  TurnThread thread([&of] { of = std::this_thread::get_id(); });
  ASSERT_TRUE(thread.run(kLong));
  EXPECT_NE(of, std::this_thread::get_id());
  const auto before = of;
  ASSERT_TRUE(thread.run(kLong));
  EXPECT_EQ(of, before);
}

TEST(TurnThread, endsAfterTheTurnThatIsInProgress) {
  std::atomic<bool> isReleased{false}, hasEnded{false};
  {
    TurnThread thread([&] {
      isReleased.wait(false);
      hasEnded = true;
    });
    EXPECT_FALSE(thread.run(ModulePatience(1ms)));
    isReleased = true;
    isReleased.notify_all();
  }
  EXPECT_TRUE(hasEnded);
}

TEST(TurnThread, aStopCutsTheWaitShort) {
  std::atomic<bool> isReleased{false}, hasBegun{false};
  TurnThread thread([&] {
    hasBegun = true;
    hasBegun.notify_all();
    isReleased.wait(false);
  });
  ModulePatience patience(10min);
  std::thread person([&] {
    hasBegun.wait(false);
    patience.cut();
  });
  EXPECT_FALSE(thread.run(patience));
  person.join();
  isReleased = true;
  isReleased.notify_all();
  EXPECT_TRUE(thread.waitFor(30s));
  patience.restore();
  EXPECT_FALSE(patience.isOver(ModulePatience::Clock::now()));
}

TEST(TurnThread, atTheEndAllThatHangAreWaitedForTogether) {
  ModulePatience patience(10min);
  // A wait that begins much later: it would be over long after that.
  const auto later = ModulePatience::Clock::now() + 1h;
  EXPECT_FALSE(patience.isOver(later));
  patience.cut();
  patience.end();
  EXPECT_TRUE(eventually([&] { return patience.isOver(later); }));
  patience.restore();
  EXPECT_TRUE(patience.isOver(later)) << "the end is final";
}

}  // namespace
}  // namespace app
