// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/OptionMachine.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace modules {
namespace {

/// "game/play kick/wait", the active options with their states.
std::string path(const OptionMachine& machine) {
  std::string text;
  for (const auto& active : machine.active())
    text += (text.empty() ? "" : " ") + active.option->name() + "/" + active.state->name();
  return text;
}

/// A root that plays or rests, and an option below it that searches, then acts until it is done.
class OptionMachineTest : public testing::Test {
 protected:
  OptionMachineTest() {
    OptionMachine::Option& game = machine_.option("game", "Plays or rests.");
    OptionMachine::Option& act = machine_.option("act", "Finds something, and uses it.");
    game.state("play", "Plays.").activates(act).to("rest", "it has been done", [this] {
      return machine_.subDone();
    });
    game.state("rest", "Rests.").does([this] { ++rested_; });
    game.always("rest", "the whistle was blown", [this] { return whistle_; });
    act.state("search", "Looks.")
        .does([this] { searchedFor_ = machine_.stateTime(); })
        .to("use", "found", [this] { return found_; })
        .to("give up", "it takes too long", [this] { return machine_.stateTime() > 5; });
    act.state("use", "Uses it.")
        .begins([this] { ++begun_; })
        .does([this] { ++used_; })
        .to("search", "lost", [this] { return !found_; });
    act.state("give up", "Waits.").isDone();
  }
  void advance(double time) { machine_.advance(time); }

  OptionMachine machine_;
  bool whistle_ = false, found_ = false;
  double searchedFor_ = -1;
  int rested_ = 0, begun_ = 0, used_ = 0;
};

TEST_F(OptionMachineTest, activeOptionsAreAPathFromTheRoot) {
  advance(1);
  EXPECT_EQ(path(machine_), "game/play act/search");
  EXPECT_EQ(searchedFor_, 0);
  advance(3);
  EXPECT_EQ(searchedFor_, 2);
  EXPECT_TRUE(machine_.changes().empty());
}

TEST_F(OptionMachineTest, aTransitionIsTakenWithItsReasonAndItsTime) {
  advance(1);
  found_ = true;
  advance(2);
  EXPECT_EQ(path(machine_), "game/play act/use");
  EXPECT_EQ(machine_.active()[1].reason, "found");
  EXPECT_EQ(machine_.active()[1].since, 2);
  ASSERT_EQ(machine_.changes().size(), 1U);
  EXPECT_EQ(machine_.changes()[0].option->name(), "act");
  advance(3);
  EXPECT_EQ(machine_.active()[1].since, 2);
  EXPECT_EQ(begun_, 1);
  EXPECT_EQ(used_, 2);
}

TEST_F(OptionMachineTest, commonTransitionsComeFirstAndNotFromTheirOwnState) {
  whistle_ = true;
  advance(1);
  EXPECT_EQ(path(machine_), "game/rest");
  EXPECT_EQ(machine_.active()[0].reason, "the whistle was blown");
  advance(2);
  EXPECT_EQ(machine_.active()[0].since, 1);
  EXPECT_EQ(rested_, 2);
}

TEST_F(OptionMachineTest, anOptionThatBecomesActiveAgainBeginsAnew) {
  found_ = true;
  advance(1);
  advance(2);
  whistle_ = true;
  advance(3);
  whistle_ = false;
  machine_.setControl({.forced = {{"game", "play"}}});
  found_ = false;
  advance(4);
  EXPECT_EQ(path(machine_), "game/play act/search");
  EXPECT_EQ(machine_.active()[1].since, 4);
}

TEST_F(OptionMachineTest, anOptionThatReachedItsAimIsKnownToTheOneAbove) {
  advance(0);
  advance(6);
  EXPECT_EQ(path(machine_), "game/play act/give up");
  advance(7);
  EXPECT_EQ(path(machine_), "game/rest");
}

TEST_F(OptionMachineTest, aForcedStateStaysUntilItIsReleased) {
  machine_.setControl({.forced = {{"act", "use"}, {"game", "nonsense"}}});
  advance(1);
  advance(2);
  EXPECT_EQ(path(machine_), "game/play act/use");
  EXPECT_TRUE(machine_.active()[1].forced);
  EXPECT_FALSE(machine_.active()[0].forced);
  EXPECT_EQ(machine_.active()[1].since, 1);
  machine_.setControl({});
  advance(3);
  EXPECT_EQ(path(machine_), "game/play act/search");
  EXPECT_FALSE(machine_.active()[1].forced);
}

TEST_F(OptionMachineTest, aMachineThatHoldsTakesOneTransitionForEachStep) {
  advance(1);
  machine_.setControl({.hold = true, .steps = 7});
  found_ = true;
  advance(2);
  EXPECT_EQ(path(machine_), "game/play act/search") << "a number of steps that it began with grants nothing";
  machine_.setControl({.hold = true, .steps = 8});
  advance(3);
  EXPECT_EQ(path(machine_), "game/play act/use");
  found_ = false;
  advance(4);
  EXPECT_EQ(path(machine_), "game/play act/use");
  machine_.setControl({});
  advance(5);
  EXPECT_EQ(path(machine_), "game/play act/search");
}

TEST(OptionMachineControlTest, forcedStatesAreReadFromText) {
  const auto forced = OptionMachine::forcedStates(" keep goal = clear,strike=kick, nonsense, =x, y= ");
  EXPECT_THAT(forced,
              testing::ElementsAre(testing::Pair("keep goal", "clear"), testing::Pair("strike", "kick")));
  EXPECT_TRUE(OptionMachine::forcedStates("").empty());
}

TEST_F(OptionMachineTest, whatCannotBeForcedIsSaidWithWhatThereIs) {
  EXPECT_EQ(machine_.wrongWith(""), "");
  EXPECT_EQ(machine_.wrongWith("game=rest, act = give up"), "");
  EXPECT_THAT(machine_.wrongWith("gam=rest"), testing::HasSubstr("no option 'gam'; did you mean 'game'"));
  EXPECT_THAT(machine_.wrongWith("game=play, act=fly"),
              testing::AllOf(testing::HasSubstr("act has no state 'fly'"), testing::HasSubstr("give up")));
  EXPECT_THAT(machine_.wrongWith("rest"), testing::HasSubstr("no option 'rest'"));
  EXPECT_THAT(machine_.wrongWith("game"), testing::HasSubstr("no state ''"));
  for (const char* text : {"game=rest,,act=use", ",game=rest", "game=rest, "})
    EXPECT_THAT(machine_.wrongWith(text), testing::HasSubstr("an empty part")) << text;
  EXPECT_EQ(machine_.wrongWith("  "), "");
}

TEST_F(OptionMachineTest, restartingBeginsWithTheFirstState) {
  whistle_ = true;
  advance(1);
  whistle_ = false;
  machine_.restart();
  advance(2);
  EXPECT_EQ(path(machine_), "game/play act/search");
}

TEST(OptionMachineErrorsTest, unknownStatesAndCirclesAreFoundAtOnce) {
  OptionMachine machine;
  machine.option("a", "").state("s", "").to("t", "", [] { return true; });
  EXPECT_THROW(machine.advance(0), std::logic_error);
  OptionMachine circle;
  auto& a = circle.option("a", "");
  auto& b = circle.option("b", "");
  a.state("s", "").activates(b);
  b.state("s", "").activates(a);
  EXPECT_THROW(circle.advance(0), std::logic_error);
  OptionMachine empty;
  EXPECT_THROW(empty.advance(0), std::logic_error);
}

}  // namespace
}  // namespace modules
