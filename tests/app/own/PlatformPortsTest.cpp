// SPDX-License-Identifier: GPL-3.0-or-later
// A platform at one end, what stands for it in the process of a program at the other end, and no line
// between.
#include "app/core/own/PlatformPorts.h"

#include <gmock/gmock.h>

#include "app/core/own/MirrorPlatform.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/process/Receiver.h"
#include "robotlink/process/Sender.h"
#include "tests/app/program/FakeProgram.h"

namespace app {
namespace {

using robotcontrol::DriveRequest;
using robotcontrol::DriveState;
using robotlink::Blocking;

class PlatformPortsTest : public testing::Test {
 protected:
  PlatformPortsTest() {
    platform_.frame = [this] {
      auto state = std::make_shared<DriveState>();
      state->set_left_speed(++sent_);
      state_.send(state);
    };
  }

  /// What stands for the remote platform; `turns` as those of OwnProgramOptions.
  std::unique_ptr<MirrorPlatform> mirror(const std::map<std::string, std::string>& turns = {}) {
    robotcontrol::WireSetup setup;
    ports_.describeTo(setup, turns);
    return std::make_unique<MirrorPlatform>(setup, clock_);
  }
  static PlatformPorts::Indices first() {
    PlatformPorts::Indices indices;
    indices.Add(0);
    return indices;
  }
  static void run(robotlink::Process& process) {
    ASSERT_TRUE(process.tryBeginFrame());
    process.runFrame();
  }
  PlatformPorts::Packages taken() {
    PlatformPorts::Packages packages;
    ports_.takeTo(packages);
    return packages;
  }

  robotlink::ManualClock clock_;
  test::FakePlatform platform_{clock_};
  robotlink::Sender<DriveState> state_{platform_, "drive/state", Blocking::kNo};
  robotlink::Receiver<DriveRequest> request_{platform_, "drive/request", Blocking::kNo};
  double sent_ = 0;
  StandInProcess host_{"host", clock_};
  PlatformPorts ports_{platform_, host_};
  /// The program elsewhere.
  StandInProcess program_{"program", clock_};
  robotlink::Receiver<DriveState> seen_{program_, "drive/state", Blocking::kNo};
  robotlink::Sender<DriveRequest> wanted_{program_, "drive/request", Blocking::kNo};
};

TEST_F(PlatformPortsTest, aMirrorHasThePortsOfThePlatform) {
  const auto other = mirror();
  EXPECT_EQ(other->name(), "body");
  ASSERT_EQ(other->senders().size(), 1U);
  EXPECT_EQ(other->senders()[0]->package(), "drive/state");
  ASSERT_EQ(other->receivers().size(), 1U);
  EXPECT_EQ(other->receivers()[0]->package(), "drive/request");
  EXPECT_TRUE(other->onRequest().empty());
}

TEST_F(PlatformPortsTest, whatThePlatformSendsComesToTheProgram) {
  const auto other = mirror();
  connectUnchecked(*other->senders()[0], seen_);
  PlatformPorts::Indices connected;
  other->connectedTo(connected);
  ASSERT_EQ(connected.size(), 1);
  ports_.connect({}, connected);
  run(platform_);
  other->setPackages(taken());
  run(*other);
  run(program_);
  ASSERT_NE(seen_.get(), nullptr);
  EXPECT_EQ(seen_.get()->left_speed(), 1);
  EXPECT_TRUE(taken().empty()) << "only once";
}

TEST_F(PlatformPortsTest, whatTheProgramSendsComesToThePlatform) {
  const auto other = mirror();
  connectUnchecked(wanted_, *other->receivers()[0]);
  PlatformPorts::Indices fed;
  other->fedTo(fed);
  ASSERT_EQ(fed.size(), 1);
  ports_.connect(fed, {});
  auto request = std::make_shared<DriveRequest>();
  request->mutable_velocity()->set_x(0.25);
  program_.setFrame([&] { wanted_.send(request); });
  run(program_);
  PlatformPorts::Packages packages;
  other->takeTo(packages);
  ASSERT_EQ(packages.size(), 1);
  ports_.send(packages);
  run(platform_);
  ASSERT_NE(request_.get(), nullptr);
  EXPECT_EQ(request_.get()->velocity().x(), 0.25);
  packages.Clear();
  other->takeTo(packages);
  EXPECT_TRUE(packages.empty()) << "only once";
}

TEST_F(PlatformPortsTest, ofWhatNobodyReceivesOnlyTheTypeIsSent) {
  ports_.connect({}, {});
  run(platform_);
  const auto packages = taken();
  ASSERT_EQ(packages.size(), 1);
  EXPECT_EQ(packages[0].type(), "robotcontrol.DriveState");
  EXPECT_EQ(packages[0].data(), "");
}

TEST_F(PlatformPortsTest, aProgramThatFallsBehindGetsTheNewestOnly) {
  ports_.connect({}, first());
  for (int i = 0; i < 2; ++i) run(platform_);
  EXPECT_EQ(taken().size(), 2);
  ports_.setBehind(true);
  for (int i = 0; i < 3; ++i) run(platform_);
  const auto packages = taken();
  ASSERT_EQ(packages.size(), 1);
  const auto newest = packageIn(packages[0]);
  EXPECT_EQ(dynamic_cast<const DriveState&>(*newest).left_speed(), 5);
}

TEST_F(PlatformPortsTest, afterClosingNothingIsCollected) {
  ports_.connect({}, first());
  run(platform_);
  ports_.close();
  run(platform_);
  EXPECT_TRUE(taken().empty());
}

TEST_F(PlatformPortsTest, unknownPortsAndTypesAreIgnored) {
  const auto other = mirror();
  connectUnchecked(*other->senders()[0], seen_);
  ports_.connect(first(), first());
  PlatformPorts::Packages packages;
  assign(*packages.Add(), 99, DriveState());
  packages.Add()->set_type("robotcontrol.NoSuchType");
  assign(*packages.Add(), 0, DriveRequest());
  packages[2].set_data("\xff\xff");
  other->setPackages(packages);
  run(*other);
  run(program_);
  EXPECT_EQ(seen_.get(), nullptr);
  ports_.send(packages);
  run(platform_);
  EXPECT_EQ(request_.get(), nullptr);
}

TEST_F(PlatformPortsTest, aPackageOfAnotherTypeThanItsNameIsIgnored) {
  ports_.connect(first(), first());
  PlatformPorts::Packages packages;
  assign(*packages.Add(), 0, DriveState());
  ports_.send(packages);
  run(platform_);
  EXPECT_EQ(request_.get(), nullptr) << "the platform would read it as a request";
}

TEST_F(PlatformPortsTest, packagesOfATurnWaitForIt) {
  const auto other = mirror({{"drive/state", "cognition"}});
  connectUnchecked(*other->senders()[0], seen_);
  EXPECT_EQ(other->turnOf("motion"), nullptr);
  robotlink::Process* turn = other->turnOf("cognition");
  ASSERT_NE(turn, nullptr);
  ports_.connect({}, first());
  run(platform_);
  other->setPackages(taken());
  run(*other);
  run(program_);
  EXPECT_EQ(seen_.get(), nullptr);
  run(*turn);
  run(program_);
  ASSERT_NE(seen_.get(), nullptr);
}

TEST_F(PlatformPortsTest, whoSendsAPackageWakesTheProgram) {
  const auto other = mirror();
  int calls = 0;
  other->setWakeUp([&calls] { ++calls; });
  connectUnchecked(wanted_, *other->receivers()[0]);
  program_.setFrame([&] { wanted_.send(std::make_shared<DriveRequest>()); });
  run(program_);
  EXPECT_GT(calls, 0);
}

}  // namespace
}  // namespace app
