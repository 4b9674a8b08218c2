// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/TurnCrew.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/Eventually.h"

namespace app {
namespace {

using namespace std::chrono_literals;

const ModulePatience kLong(30s);
constexpr std::size_t kOne[] = {0};
constexpr std::size_t kThree[] = {0, 1, 2};

/// Makes a turn of the only member; whether it has ended.
bool run(TurnCrew& crew, const ModulePatience& patience) {
  return crew.run(kOne, patience).empty();
}

TEST(TurnCrew, whoAsksForATurnGetsItsResultAtOnce) {
  int turns = 0;
  TurnCrew thread(1, [&](std::size_t) { ++turns; });
  for (int i = 1; i <= 100; ++i) {
    EXPECT_TRUE(run(thread, kLong));
    EXPECT_EQ(turns, i);
    EXPECT_FALSE(thread.isBusy(0));
  }
}

TEST(TurnCrew, aTurnThatDoesNotReturnKeepsNobody) {
  std::atomic<bool> isReleased{false};
  TurnCrew thread(1, [&](std::size_t) { isReleased.wait(false); });
  EXPECT_FALSE(run(thread, ModulePatience(1ms)));
  EXPECT_TRUE(thread.isBusy(0));
  EXPECT_FALSE(thread.waitFor(0, 1ms));
  isReleased = true;
  isReleased.notify_all();
  EXPECT_TRUE(thread.waitFor(0, 30s));
  EXPECT_TRUE(run(thread, kLong));
}

TEST(TurnCrew, makesTurnsInOneThreadOfItsOwn) {
  std::thread::id of;
  TurnCrew thread(1, [&of](std::size_t) { of = std::this_thread::get_id(); });
  ASSERT_TRUE(run(thread, kLong));
  EXPECT_NE(of, std::this_thread::get_id());
  const auto before = of;
  ASSERT_TRUE(run(thread, kLong));
  EXPECT_EQ(of, before);
}

TEST(TurnCrew, makesTurnsOfSeveralMembersAtOnce) {
  // Each turn waits for the other ones.
  std::atomic<int> begun{0};
  TurnCrew crew(3, [&](std::size_t) {
    ++begun;
    while (begun % 3 != 0) std::this_thread::yield();
  });
  EXPECT_TRUE(crew.run(kThree, kLong).empty());
  EXPECT_EQ(begun, 3);
}

TEST(TurnCrew, withOneThreadTurnsFollowEachOtherInOrder) {
  std::vector<std::size_t> order;
  TurnCrew crew(1, [&](std::size_t member) { order.push_back(member); });
  EXPECT_TRUE(crew.run(kThree, kLong).empty());
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(TurnCrew, aTurnThatDoesNotReturnKeepsNoOtherMember) {
  std::atomic<bool> isReleased{false};
  std::atomic<int> others{0};
  TurnCrew crew(2, [&](std::size_t member) {
    if (member != 1) {
      ++others;
    } else {
      isReleased.wait(false);
    }
  });
  EXPECT_EQ(crew.run(kThree, ModulePatience(1ms)), (std::vector<std::size_t>{1}));
  EXPECT_EQ(others, 2);
  EXPECT_TRUE(crew.isBusy(1));
  constexpr std::size_t kRest[] = {0, 2};
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(crew.run(kRest, kLong).empty());
  EXPECT_EQ(others, 8);
  isReleased = true;
  isReleased.notify_all();
  EXPECT_TRUE(crew.waitFor(1, 30s));
  EXPECT_TRUE(crew.run(kThree, kLong).empty());
}

TEST(TurnCrew, endsAfterTheTurnThatIsInProgress) {
  std::atomic<bool> isReleased{false}, hasEnded{false};
  {
    TurnCrew thread(1, [&](std::size_t) {
      isReleased.wait(false);
      hasEnded = true;
    });
    EXPECT_FALSE(run(thread, ModulePatience(1ms)));
    isReleased = true;
    isReleased.notify_all();
  }
  EXPECT_TRUE(hasEnded);
}

TEST(TurnCrew, aStopCutsTheWaitShort) {
  std::atomic<bool> isReleased{false}, hasBegun{false};
  TurnCrew thread(1, [&](std::size_t) {
    hasBegun = true;
    hasBegun.notify_all();
    isReleased.wait(false);
  });
  ModulePatience patience(10min);
  std::thread person([&] {
    hasBegun.wait(false);
    patience.cut();
  });
  EXPECT_FALSE(run(thread, patience));
  person.join();
  isReleased = true;
  isReleased.notify_all();
  EXPECT_TRUE(thread.waitFor(0, 30s));
  patience.restore();
  EXPECT_FALSE(patience.isOver(ModulePatience::Clock::now()));
}

TEST(TurnCrew, atTheEndAllThatHangAreWaitedForTogether) {
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
