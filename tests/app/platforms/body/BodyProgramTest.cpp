// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/BodyProgram.h"

#include <gmock/gmock.h>

#include "app/core/remote/BodyStreams.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotcontrol::BodyCommands;
using robotcontrol::BodyState;
using robotlink::Instant;
using testing::HasSubstr;

/// A simulated robot that is only a body, stepped by the test: the simulated time is the clock.
class BodyProgramTest : public testing::Test {
 protected:
  BodyProgramTest() {
    RunOptions options = defaultSimulation();
    options.world.noise = false;
    options.world.blackout = true;
    options.instead = BodyProgram::maker({.inbox = inbox_});
    SimulatedRun::Listeners listeners;
    listeners.queue = [this](const std::string&, const auto& queue) {
      for (const auto& message : queue->messages) newest_[message.path] = message.content;
    };
    auto run = SimulatedRun::create(options, listeners);
    EXPECT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
    run_->step();
    run_->step();
  }
  Instant now() const { return run_->world().clock().now(); }
  void stepFor(robotlink::Duration time) {
    for (const Instant end = now() + time; now() < end;) run_->step();
  }
  template <typename T>
  const T& newest(const std::string& path) {
    return dynamic_cast<const T&>(*newest_.at(path));
  }
  const BodyState& state() { return newest<BodyState>(kBodyState); }
  double angle(int joint) {
    return newest<foxglove::JointStates>(robotlink::kJointStates.name).joints(joint).position();
  }
  BodyCommands commands(Instant basedOn, double angle = 0.5) {
    robotcontrol::JointRequest joints;
    joints.set_stiffness(1);
    for (int i = 0; i < 18; ++i) joints.add_positions(i == 1 ? angle : std::nan(""));
    BodyCommands commands;
    robotlink::assign(*commands.mutable_based_on(), basedOn);
    auto& package = *commands.add_packages();
    package.set_package(robotlink::kJointRequest.name);
    package.set_type(joints.GetTypeName());
    joints.SerializeToString(package.mutable_data());
    return commands;
  }
  std::string put(BodyCommands commands, std::uint64_t client = 1) {
    return inbox_->put("red1", {client, "desk " + std::to_string(client)}, std::move(commands), real_);
  }

  const std::shared_ptr<BodyInbox> inbox_ = std::make_shared<BodyInbox>();
  Instant real_;
  std::map<std::string, robotlink::PackagePtr> newest_;
  std::unique_ptr<SimulatedRun> run_;
};

TEST_F(BodyProgramTest, itSaysWhatItOffersAndSendsReadingsInEachFrame) {
  const auto& offer = newest<robotcontrol::BodyOffer>(kBodyOffer);
  EXPECT_EQ(offer.robot(), "red1");
  EXPECT_EQ(offer.kind(), "ers210");
  EXPECT_THAT(offer.sensors(), testing::IsSupersetOf({"camera/image", "joints/states", "body/sensors"}));
  EXPECT_THAT(offer.sensors(), testing::Not(testing::Contains("oracle/classes")));
  // What moves it, and what its radio sends to the others of its team.
  EXPECT_THAT(offer.commands(), testing::ElementsAre("joints/request", "team/message"));
  EXPECT_EQ(offer.watchdog(), 0.5);
  const auto before = state().frame();
  stepFor(80ms);
  EXPECT_EQ(state().frame(), before + 10);
  EXPECT_EQ(robotlink::instant(newest<foxglove::JointStates>("joints/states").timestamp()),
            robotlink::instant(state().timestamp()));
}

TEST_F(BodyProgramTest, itStandsUntilSomebodyCommandsItAndThenObeys) {
  EXPECT_TRUE(state().stands());
  EXPECT_THAT(state().text(), HasSubstr("no program commands it yet"));
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(put(commands(now())), "");
    run_->step();
  }
  EXPECT_FALSE(state().stands());
  EXPECT_EQ(state().commands(), 100U);
  EXPECT_NEAR(angle(1), 0.5, 0.1);
}

TEST_F(BodyProgramTest, withoutCommandsItStandsAfterHalfASecondOfItsOwnTime) {
  put(commands(now()));
  stepFor(490ms);
  EXPECT_FALSE(state().stands());
  stepFor(30ms);
  EXPECT_TRUE(state().stands());
  EXPECT_THAT(state().text(),
              HasSubstr("for 0.5 s no command of the program of desk 1 arrived in time; the link may"));
  const double held = angle(1);
  stepFor(300ms);
  EXPECT_NEAR(angle(1), held, 0.05);
  // It goes on when they have come in time for half a second.
  const auto obeyFor = [this](robotlink::Duration time) {
    for (const Instant end = now() + time; now() < end;) {
      put(commands(now()));
      run_->step();
    }
  };
  obeyFor(490ms);
  EXPECT_TRUE(state().stands());
  obeyFor(40ms);
  EXPECT_FALSE(state().stands());
}

TEST_F(BodyProgramTest, aLineOnWhichCommandsAreNowInTimeNowTooLateDoesNotLetItGoAndStandInTurn) {
  put(commands(now()));
  stepFor(600ms);
  ASSERT_TRUE(state().stands());
  int changes = 0;
  bool stood = true;
  for (int i = 0; i < 500; ++i) {
    put(commands(now() - (i % 20 < 10 ? 100ms : 600ms)));
    run_->step();
    changes += state().stands() != stood ? 1 : 0;
    stood = state().stands();
  }
  EXPECT_EQ(changes, 0);
  EXPECT_TRUE(state().stands());
}

TEST_F(BodyProgramTest, commandsThatComeTooLateAreCountedAndNotObeyed) {
  stepFor(1s);
  for (int i = 0; i < 50; ++i) {
    put(commands(now() - 600ms));
    run_->step();
  }
  EXPECT_TRUE(state().stands());
  EXPECT_EQ(state().commands(), 0U);
  EXPECT_EQ(state().late(), 50U);
}

TEST_F(BodyProgramTest, commandsOfAnotherLifeAreNotObeyed) {
  put(commands(now() + 5s));
  stepFor(20ms);
  EXPECT_TRUE(state().stands());
  EXPECT_EQ(state().late(), 1U);
}

TEST_F(BodyProgramTest, stopWhereTheProgramRunsLetsItStandAtOnce) {
  put(commands(now()));
  stepFor(40ms);
  BodyCommands stop;
  robotlink::assign(*stop.mutable_based_on(), now());
  stop.set_stop(true);
  put(stop);
  stepFor(20ms);
  EXPECT_TRUE(state().stands());
  EXPECT_THAT(state().text(), HasSubstr("STOP is engaged where its program runs"));
}

TEST_F(BodyProgramTest, itObeysOneProgramAtATime) {
  EXPECT_EQ(put(commands(now()), 1), "");
  EXPECT_THAT(put(commands(now()), 2), HasSubstr("obeys the program of desk 1"));
  real_ += 3s;
  EXPECT_EQ(put(commands(now()), 2), "");
}

TEST_F(BodyProgramTest, theCommandsOfEachProgramAreCountedOnTheirOwn) {
  for (const std::uint64_t sender : {7U, 9U}) {
    real_ += 3s;
    for (std::uint64_t number = 1; number <= 3; ++number) {
      BodyCommands next = commands(now());
      next.set_sender(sender);
      ASSERT_EQ(put(next, sender), "");
      stepFor(40ms);
      EXPECT_EQ(state().commander(), sender);
      EXPECT_EQ(state().commands(), number);
    }
  }
}

TEST_F(BodyProgramTest, packagesOfAnotherTypeAreIgnored) {
  BodyCommands wrong = commands(now());
  wrong.mutable_packages(0)->set_type("robotcontrol.DriveRequest");
  wrong.add_packages()->set_package("no/such");
  put(wrong);
  stepFor(40ms);
  EXPECT_FALSE(state().stands());
  EXPECT_NEAR(angle(1), 0, 0.4);
}

TEST_F(BodyProgramTest, whatNeedsAProgramIsRefused) {
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name("ball-percept/disc");
  const auto done = run_->request(request);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text, HasSubstr("runs elsewhere"));
}

}  // namespace
}  // namespace app
