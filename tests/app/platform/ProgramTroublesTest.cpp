// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/ProgramTroubles.h"

#include <gmock/gmock.h>

#include <sstream>

#include "robotcontrol/Hosting.pb.h"

namespace app {
namespace {

using robotcontrol::HostingStatus;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Trouble = ProgramTroubles::Trouble;

HostingStatus hosting(HostingStatus::State state, const std::string& text, const std::string& stack = {}) {
  HostingStatus status;
  status.set_state(state);
  status.set_text(text);
  status.set_stack(stack);
  return status;
}

class ProgramTroublesTest : public testing::Test {
 protected:
  std::ostringstream out_;
  ProgramTroubles troubles_{out_};
};

TEST_F(ProgramTroublesTest, aCrashIsPrintedWithItsStackAndKept) {
  troubles_.note("red1", hosting(HostingStatus::RUNNING, ""));
  EXPECT_FALSE(troubles_.any());
  troubles_.note("red1", hosting(HostingStatus::ENDED, "The program of red1 crashed.", "Ball::find()\n"));
  EXPECT_EQ(out_.str(), "red1: The program of red1 crashed.\nBall::find()\n");
  EXPECT_THAT(troubles_.all(), ElementsAre(Trouble{"red1", "The program of red1 crashed."}));
}

TEST_F(ProgramTroublesTest, theSameTroubleIsNotedOnceUntilTheProgramRunsAgain) {
  const auto crash = hosting(HostingStatus::ENDED, "It crashed.");
  for (int i = 0; i < 3; ++i) troubles_.note("red1", crash);
  EXPECT_EQ(troubles_.all().size(), 1U);
  troubles_.note("red1", hosting(HostingStatus::RUNNING, ""));
  troubles_.note("red1", crash);
  troubles_.note("blue1", crash);
  EXPECT_EQ(troubles_.all().size(), 3U);
}

TEST_F(ProgramTroublesTest, aProgramThatRunsAgainIsPrintedOnly) {
  troubles_.note("red1", hosting(HostingStatus::RUNNING, "The program of red1 answers again."));
  EXPECT_THAT(out_.str(), HasSubstr("answers again"));
  EXPECT_THAT(troubles_.all(), IsEmpty());
}

TEST_F(ProgramTroublesTest, aProcessThatWasStoppedIsKeptAndOneThatStarvesIsNot) {
  troubles_.note("red1", "Process cognition waits for camera/image");
  EXPECT_THAT(troubles_.all(), IsEmpty());
  troubles_.note("red1", "Process cognition was stopped because it threw: out of \x1B[2J range");
  EXPECT_THAT(
      troubles_.all(),
      ElementsAre(Trouble{"red1", "Process cognition was stopped because it threw: out of ?[2J range"}));
  EXPECT_THAT(out_.str(), HasSubstr("waits for camera/image"));
}

}  // namespace
}  // namespace app
