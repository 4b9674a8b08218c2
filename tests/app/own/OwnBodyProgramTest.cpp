// SPDX-License-Identifier: GPL-3.0-or-later
// Programs here for remote bodies, in processes of their own: in real time, with threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "tests/app/platforms/body/BodyBench.h"

namespace {

using namespace app;
using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;
using testing::HasSubstr;

class OwnBodyProgramTest : public testing::Test {
 protected:
  BodyOptions options() const {
    BodyOptions options{.url = test::urlOf(hall_.port())};
    options.program.hosting.ownProcesses = true;
    options.program.own.executable = OWN_PROGRAM_CHILD;
    options.program.own.patience = std::chrono::seconds(5);
    return options;
  }
  const HostingStatus& hosting() {
    static const HostingStatus kUnknown;
    const auto* status = desk_.newest<HostingStatus>("red1/hosting");
    return status == nullptr ? kUnknown : *status;
  }
  void choose(const HostProgram& choice) {
    robotcontrol::Request request;
    *request.mutable_host_program() = choice;
    desk_.ask(request);
  }

  test::OfferedBodies hall_{"scenes/field2002.sdf"};
  test::BodyDesk desk_{options(), hall_.port()};
};

TEST_F(OwnBodyProgramTest, itMovesTheBodyAsAProgramInsideDoes) {
  EXPECT_TRUE(desk_.soon([&] { return desk_.bodyMoves(); }));
  EXPECT_TRUE(hosting().own_process());
  EXPECT_TRUE(hosting().threads());
  desk_.show("camera/image");
  EXPECT_TRUE(
      desk_.soon([&] { return desk_.newest<google::protobuf::Message>("red1/camera/image") != nullptr; }));
}

TEST_F(OwnBodyProgramTest, whenItEndsTheBodyStandsUntilItIsStartedAgain) {
  ASSERT_TRUE(desk_.soon([&] { return desk_.bodyMoves() && hosting().pid() != 0; }));
  ASSERT_EQ(::kill(static_cast<pid_t>(hosting().pid()), SIGKILL), 0);
  EXPECT_TRUE(desk_.soon([&] { return hosting().state() == HostingStatus::ENDED && desk_.bodyStands(); }));
  EXPECT_THAT(hosting().text(), HasSubstr("was killed"));
  HostProgram again;
  again.set_start_again(true);
  choose(again);
  EXPECT_TRUE(desk_.soon([&] { return hosting().state() == HostingStatus::RUNNING && desk_.bodyMoves(); }));
}

TEST_F(OwnBodyProgramTest, whileItIsSilentTheBodyStands) {
  ASSERT_TRUE(desk_.soon([&] { return desk_.bodyMoves() && hosting().pid() != 0; }));
  const auto pid = static_cast<pid_t>(hosting().pid());
  ASSERT_EQ(::kill(pid, SIGSTOP), 0);
  EXPECT_TRUE(
      desk_.soon([&] { return hosting().state() == HostingStatus::NOT_ANSWERING && desk_.bodyStands(); }));
  EXPECT_THAT(hosting().text(), HasSubstr("gdb -p " + std::to_string(pid)));
  ASSERT_EQ(::kill(pid, SIGCONT), 0);
  EXPECT_TRUE(desk_.soon([&] { return hosting().state() == HostingStatus::RUNNING && desk_.bodyMoves(); }));
}

TEST_F(OwnBodyProgramTest, itMovesBetweenItsOwnProcessAndTheWorkbenchWithTheUsersOverrides) {
  ASSERT_TRUE(desk_.soon([&] { return desk_.bodyMoves(); }));
  desk_.show("oracle/world");
  HostProgram inside;
  inside.set_where(HostProgram::IN_WORKBENCH);
  choose(inside);
  EXPECT_TRUE(desk_.soon([&] {
    return !hosting().own_process() && desk_.bodyMoves() &&
           desk_.newest<robotcontrol::OracleWorld>("red1/oracle/world") != nullptr;
  }));
}

}  // namespace
