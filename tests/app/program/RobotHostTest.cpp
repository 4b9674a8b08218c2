// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/RobotHost.h"

#include <gmock/gmock.h>

#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/session/KeyModes.h"
#include "tests/TestFolder.h"
#include "tests/app/program/FakeProgram.h"

namespace app {
namespace {

using robotcontrol::HostingStatus;
using robotcontrol::Request;
using test::FakePlatform;
using test::FakeProgram;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::StartsWith;

Request stop(bool engaged) {
  Request request;
  request.mutable_stop()->set_engaged(engaged);
  return request;
}

Request key(const std::string& name, std::uint64_t id = 0) {
  Request request;
  request.set_id(id);
  request.mutable_set_key()->set_name(name);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  return request;
}

class RobotHostTest : public testing::Test {
 protected:
  RobotHostTest() {
    RobotHost::Listeners listeners;
    listeners.platform = [this](const std::string& robot, robotlink::Instant, const std::string& text) {
      said_.push_back(robot + ": " + text);
    };
    listeners.trouble = [this](const std::string& robot, const robotlink::Process&, const std::string& text) {
      said_.push_back(robot + "! " + text);
    };
    listeners.hosting = [this](const std::string&, robotlink::Instant, const HostingStatus& status) {
      hosting_ = status;
    };
    listeners.overridden = [this](const Request& request) {
      overridden_.push_back(request.set_key().name());
    };
    host_ = std::make_unique<RobotHost>(test::fakeRobot(), listeners, nullptr);
  }

  /// Makes a program and, if there is none yet, a platform; program_ and platform_ point to them.
  RobotHost::Candidate make(bool withPlatform = true) {
    RobotHost::Parts parts;
    if (withPlatform) {
      auto platform = std::make_unique<FakePlatform>(clock_);
      platform_ = platform.get();
      parts.platform = std::move(platform);
    }
    parts.file = "walk.yaml";
    parts.maker = [this](HostedProgram::Parts) -> HostedProgram::Made {
      auto program = std::make_unique<FakeProgram>(clock_);
      program->unknown = unknown_;
      program_ = program.get();
      return program;
    };
    auto made = host_->make(std::move(parts));
    EXPECT_TRUE(made) << (made ? "" : describe(made.error()));
    return std::move(*made);
  }
  std::vector<std::string> begin() {
    executor_ = std::make_unique<ProgramExecutor>(
        ProgramExecutor::Options{.trouble = [](const auto&, const auto&) {}});
    return host_->begin(*executor_);
  }
  void start() {
    host_->adopt(make());
    begin();
  }
  /// The program answers a request.
  void answer(std::uint64_t id, bool accepted) {
    auto result = std::make_shared<robotcontrol::RequestResult>();
    result->set_id(id);
    result->set_accepted(accepted);
    auto queue = std::make_shared<robotlink::SharedDebugQueue>();
    queue->messages.push_back({"results", std::nullopt, std::move(result)});
    program_->listeners.queue(queue);
  }
  std::vector<std::string> keysAsked() const {
    std::vector<std::string> names;
    for (const Request& request : program_->requests)
      if (request.has_set_key()) names.push_back(request.set_key().name());
    return names;
  }

  robotlink::ManualClock clock_;
  FakePlatform* platform_ = nullptr;
  FakeProgram* program_ = nullptr;
  std::vector<std::string> said_, overridden_;
  /// What the programs that are made from now on do not have.
  std::set<std::string> unknown_;
  HostingStatus hosting_;
  std::unique_ptr<RobotHost> host_;
  std::unique_ptr<ProgramExecutor> executor_;
};

TEST_F(RobotHostTest, aPlatformIsSetUpOnceAndShutDownOnce) {
  start();
  EXPECT_EQ(platform_->initialized, 1);
  EXPECT_THAT(said_, ElementsAre(MatchesRegex("red1: The platform was set up in [0-9.]+ ms\\."),
                                 "red1: The legs are warm."));
  said_.clear();
  host_->stop();
  host_->adopt(make(false));
  begin();
  EXPECT_EQ(platform_->initialized, 1) << "the platform stays";
  EXPECT_THAT(said_, IsEmpty());
  host_.reset();
  EXPECT_THAT(said_, ElementsAre("red1: The legs are cold.",
                                 MatchesRegex("red1: The platform was shut down in [0-9.]+ ms\\.")));
}

TEST_F(RobotHostTest, aPlatformThatWasNeverSetUpEndsSilently) {
  host_->adopt(make());
  host_.reset();
  EXPECT_THAT(said_, ElementsAre("red1: The legs are cold."));
}

TEST_F(RobotHostTest, anotherPlatformTakesThePlaceOfTheFirst) {
  start();
  bool hasEnded = false;
  platform_->onEnd = [&hasEnded] { hasEnded = true; };
  host_->stop();
  host_->adopt(make());
  EXPECT_TRUE(hasEnded);
  begin();
  EXPECT_EQ(platform_->initialized, 1);
  EXPECT_EQ(host_->platform(), platform_);
}

TEST_F(RobotHostTest, aProgramThatCannotBeMadeChangesNothing) {
  start();
  RobotHost::Parts parts;
  parts.maker = [](HostedProgram::Parts) -> HostedProgram::Made {
    return tl::unexpected(robotlink::Errors{{"x", "no such task", {}, {}}});
  };
  const auto made = host_->make(std::move(parts));
  ASSERT_FALSE(made);
  EXPECT_THAT(describe(made.error()), HasSubstr("no such task"));
  EXPECT_EQ(host_->program(), program_);
  EXPECT_EQ(host_->layout(), "walk.yaml");
}

TEST_F(RobotHostTest, whatConcernsTheBodyGoesToThePlatform) {
  start();
  EXPECT_TRUE(RobotHost::fulfills(stop(true)));
  EXPECT_FALSE(RobotHost::fulfills(key("drawings")));
  EXPECT_TRUE(host_->request(stop(true)));
  EXPECT_TRUE(platform_->stopped);
  Request empty;
  empty.mutable_stop();
  EXPECT_TRUE(host_->request(empty));
  EXPECT_TRUE(platform_->stopped);
  EXPECT_TRUE(host_->request(stop(false)));
  EXPECT_FALSE(platform_->stopped);
  Request drive;
  drive.mutable_control_drive()->set_motors(true);
  EXPECT_TRUE(host_->request(drive));
  EXPECT_EQ(platform_->controls.size(), 1U);
  host_->enqueueRequests();
  EXPECT_THAT(keysAsked(), IsEmpty());
}

TEST_F(RobotHostTest, aPlatformThatObeysNobodySaysSo) {
  start();
  platform_->why = "this is a log";
  const auto refused = host_->request(stop(true));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text, "this is a log");
  EXPECT_FALSE(platform_->stopped);
  EXPECT_TRUE(host_->request(key("drawings"))) << "the program takes requests anyway";
}

TEST_F(RobotHostTest, whatConcernsTheProgramWaitsForTheNextStep) {
  start();
  EXPECT_TRUE(host_->request(key("drawings", 7)));
  EXPECT_THAT(keysAsked(), IsEmpty());
  host_->enqueueRequests();
  EXPECT_THAT(keysAsked(), ElementsAre("drawings"));
  host_->enqueueRequests();
  EXPECT_THAT(keysAsked(), ElementsAre("drawings")) << "only once";
}

TEST_F(RobotHostTest, requestsWaitWhileTheProgramTakesNone) {
  start();
  host_->enqueueRequests();
  program_->isFull = true;
  EXPECT_TRUE(host_->request(key("first", 1)));
  EXPECT_TRUE(host_->request(key("second", 2)));
  host_->enqueueRequests();
  EXPECT_THAT(keysAsked(), IsEmpty());
  program_->isFull = false;
  host_->enqueueRequests();
  EXPECT_THAT(keysAsked(), ElementsAre("first", "second"));
}

TEST_F(RobotHostTest, moreThanFitAreRefused) {
  start();
  program_->isFull = true;
  bool isRefused = false;
  for (std::uint64_t i = 1; i < 100'000 && !isRefused; ++i) {
    const auto done = host_->request(key("key" + std::to_string(i), i));
    isRefused = !done;
    EXPECT_THAT(done ? "too many are waiting already" : done.error().text, HasSubstr("are waiting already"));
  }
  EXPECT_TRUE(isRefused);
}

TEST_F(RobotHostTest, whatWasAcceptedIsAppliedToTheNextProgram) {
  start();
  ASSERT_TRUE(host_->request(key("kept", 1)));
  ASSERT_TRUE(host_->request(key("refused", 2)));
  host_->enqueueRequests();
  answer(1, true);
  answer(2, false);
  EXPECT_THAT(overridden_, ElementsAre("kept"));
  host_->stop();
  host_->adopt(make(false));
  begin();
  host_->enqueueRequests();
  EXPECT_THAT(keysAsked(), ElementsAre("kept"));
  EXPECT_TRUE(host_->overrides().keys().contains("kept"));
}

TEST_F(RobotHostTest, aPresetInTheRobotsFileCountsAtTheNextStartAfterItWasChanged) {
  const TestFolder folder;
  const auto write = [&folder](const std::string& mode) {
    folder.write("red1.preset.json", R"({"format": "robotcontrol-preset", "version": 1,
                                         "preset": {"keys": {"package/models/ball": ")" +
                                         mode + R"("}}})");
  };
  HostedRobot robot = test::fakeRobot();
  robot.presetFile = folder / "red1.preset.json";
  host_ = std::make_unique<RobotHost>(robot, RobotHost::Listeners{}, nullptr);
  const auto startAgain = [this] {
    host_->stop();
    host_->adopt(make(false));
    begin();
    host_->enqueueRequests();
    const auto keys = host_->overrides().keys();
    const auto found = keys.find("package/models/ball");
    return found == keys.end() ? std::string("off") : robotlink::inWords(found->second);
  };
  start();
  EXPECT_EQ(startAgain(), "off") << "there is no file";
  write("always");
  EXPECT_EQ(startAgain(), "always");
  // What somebody chose after that stays.
  Request other = key("package/models/ball", 7);
  other.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::EVERY_N);
  other.mutable_set_key()->mutable_mode()->set_n(2);
  ASSERT_TRUE(host_->request(other));
  host_->enqueueRequests();
  answer(7, true);
  EXPECT_EQ(startAgain(), "every 2");
  write("every 3");
  EXPECT_EQ(startAgain(), "every 3");
}

TEST_F(RobotHostTest, whatTheNextProgramCannotDoIsReportedAndKept) {
  start();
  Request request;
  request.set_id(1);
  request.mutable_select_solution()->set_task("ball-percept");
  request.mutable_select_solution()->set_solution("scan");
  ASSERT_TRUE(host_->request(request));
  ASSERT_TRUE(host_->request(key("drawings", 2)));
  host_->enqueueRequests();
  answer(1, true);
  answer(2, true);
  host_->stop();
  unknown_ = {"scan", "drawings"};
  host_->adopt(make(false));
  EXPECT_THAT(begin(), ElementsAre(testing::AllOf(StartsWith("red1 could not keep "), HasSubstr("scan"),
                                                  HasSubstr("there is no scan"))))
      << "a key that a layout does not have is nothing to report";
  host_->enqueueRequests();
  EXPECT_THAT(keysAsked(), IsEmpty());
  EXPECT_TRUE(host_->overrides().keys().contains("drawings")) << "for a layout that has it";
  EXPECT_EQ(host_->overrides().solutions().at("ball-percept"), "scan");
}

TEST_F(RobotHostTest, whatHasNoAnswerIsAskedOfTheNextProgramAgain) {
  start();
  ASSERT_TRUE(host_->request(key("open", 5)));
  host_->enqueueRequests();
  host_->stop();
  host_->adopt(make(false));
  begin();
  host_->enqueueRequests();
  EXPECT_THAT(keysAsked(), ElementsAre("open"));
}

TEST_F(RobotHostTest, aProgramThatHasEndedSaysSoItself) {
  start();
  program_->why = "the program of red1 crashed";
  const auto refused = host_->request(key("drawings"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text, "the program of red1 crashed");
}

TEST_F(RobotHostTest, aRobotStandsWhileAProcessThatDecidesIsMissing) {
  start();
  program_->missing = "motion";
  host_->endStep();
  EXPECT_TRUE(platform_->unattended());
  EXPECT_EQ(hosting_.state(), HostingStatus::INCOMPLETE);
  EXPECT_THAT(hosting_.text(), HasSubstr("motion"));
  program_->missing.clear();
  host_->endStep();
  EXPECT_FALSE(platform_->unattended());
  EXPECT_EQ(hosting_.state(), HostingStatus::RUNNING);
}

TEST_F(RobotHostTest, aRobotWhoseProgramDoesNotReturnStands) {
  start();
  host_->noteStuck("ball-percept (region) of process cognition");
  EXPECT_TRUE(host_->isStuck());
  EXPECT_TRUE(platform_->unattended());
  EXPECT_EQ(hosting_.state(), HostingStatus::NOT_ANSWERING);
  EXPECT_THAT(hosting_.text(), StartsWith("The program of red1 does not return from ball-percept (region)"));
  const auto refused = host_->request(key("drawings"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("does not return from ball-percept (region)"));
  EXPECT_TRUE(host_->request(stop(true))) << "STOP is obeyed whatever the program does";
  host_->noteStuck("");
  EXPECT_FALSE(platform_->unattended());
  EXPECT_EQ(hosting_.state(), HostingStatus::RUNNING);
  EXPECT_EQ(hosting_.text(), "The program of red1 has returned and continues.");
}

TEST_F(RobotHostTest, anotherProgramIsNotStuck) {
  start();
  host_->noteStuck("a task");
  host_->stop();
  host_->adopt(make(false));
  begin();
  EXPECT_FALSE(host_->isStuck());
  EXPECT_FALSE(platform_->unattended());
  EXPECT_EQ(hosting_.text(), "");
}

TEST_F(RobotHostTest, aProgramThatDoesNotReturnIsReleasedInOnePiece) {
  start();
  const FakeProgram* stuck = program_;
  const auto released = host_->release();
  EXPECT_EQ(released.get(), stuck);
  EXPECT_EQ(program_->stops, 1);
  EXPECT_EQ(host_->program(), nullptr);
  const auto platform = host_->releasePlatform();
  EXPECT_EQ(platform.get(), platform_);
  EXPECT_EQ(platform_->shut, 1);
  EXPECT_EQ(host_->platform(), nullptr);
}

TEST_F(RobotHostTest, problemsOfAProcessAreSentencesWithItsName) {
  start();
  host_->reportTrouble(program_->debugProcess(), "starves");
  EXPECT_EQ(said_.back(), "red1! Process debug starves");
}

TEST_F(RobotHostTest, thePlatformAndTheProcessesOfTheProgramAreItsOwn) {
  start();
  EXPECT_TRUE(host_->owns(*platform_));
  const FakePlatform other(clock_);
  EXPECT_FALSE(host_->owns(other));
}

}  // namespace
}  // namespace app
