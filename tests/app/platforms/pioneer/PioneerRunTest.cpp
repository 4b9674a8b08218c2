// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/real/RealRun.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

#include "app/platforms/pioneer/PioneerOptions.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/QueueMessages.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/served/ServedWorld.h"

using namespace app;
using namespace std::chrono_literals;

namespace {

/// What the robot and its program told; from all threads.
class RobotEars {
 public:
  RealRun::Listeners listeners() {
    return {[this](const std::string& robot, auto queue) {
              const std::lock_guard lock(mutex_);
              for (auto& message :
                   robotlink::messagesOf(robot, *queue, {}, robotlink::QueueReader::kViews).messages) {
                newest_[message.path] = message.value;
              }
            },
            [this](const std::string&, const robotlink::Process&, const std::string& text) {
              const std::lock_guard lock(mutex_);
              troubles_ += text + "\n";
            }};
  }
  void forget() {
    const std::lock_guard lock(mutex_);
    newest_.clear();
  }
  template <typename T>
  std::shared_ptr<const T> newest(const std::string& path) {
    const std::lock_guard lock(mutex_);
    const auto found = newest_.find(path);
    return found == newest_.end() ? nullptr : std::dynamic_pointer_cast<const T>(found->second);
  }

 private:
  std::mutex mutex_;  // protects all
  std::map<std::string, std::shared_ptr<const google::protobuf::Message>> newest_;
  std::string troubles_;
};

std::atomic<bool> letGo{false}, hangs{false};

/// A program's part that never returns, until the test lets it go.
class Hanging final : public robotlink::Solution {
 public:
  explicit Hanging(robotlink::SolutionContext& context) : drive_(context.input(robotlink::kDriveState)) {}
  void execute() override {
    hangs = true;
    letGo.wait(false);
  }

 private:
  robotlink::Input<robotcontrol::DriveState> drive_;
};
const robotlink::SolutionRegistration kHanging =
    robotlink::SolutionBuilder<Hanging>("pioneer-run-test", "hang", "Never returns.")
        .needs(robotlink::kDriveState);

class PioneerRunTest : public testing::Test {
 protected:
  PioneerRunTest() {
    std::ofstream(layout_) << "version: 1\nname: bare\nhelp: Nothing but debugging.\n"
                              "processes:\n  - {name: debug, debug: true, period_ms: 16}\n";
  }
  void connect() {
    auto run = RealRun::create(robot(), ears_.listeners());
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
    for (const char* package : {"drive/state", "range/sonar", "link/status", "link/packets"}) {
      robotcontrol::Request request;
      request.set_robot("p3at1");
      request.mutable_set_key()->set_name(std::string("package/") + package);
      request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
      EXPECT_TRUE(run_->request(request));
    }
  }
  bool playUntil(const std::function<bool()>& happens) {
    return eventually([&] {
      run_->step();
      return happens();
    });
  }
  RealRobotOptions robot() const {
    RealRobotOptions options = pioneerOptions(world_.url());
    options.program.layout = layout_;
    return options;
  }
  bool connected() const { return run_->platform().isConnected(); }
  std::shared_ptr<const robotcontrol::DriveState> state() {
    return ears_.newest<robotcontrol::DriveState>("p3at1/drive/state");
  }
  robotlink::Result<void> motors(bool on) {
    robotcontrol::Request request;
    request.set_robot("p3at1");
    request.mutable_control_drive()->set_motors(on);
    return run_->request(request);
  }

  ServedWorld world_;
  RobotEars ears_;
  const TestFolder folder_;
  const std::filesystem::path layout_ = folder_ / "bare.yaml";
  std::unique_ptr<RealRun> run_;
};

}  // namespace

TEST_F(PioneerRunTest, aRobotAtTheEndOfALinePublishesWhatASimulatedOneDoes) {
  connect();
  ASSERT_TRUE(
      playUntil([&] { return state() && ears_.newest<robotcontrol::SonarReadings>("p3at1/range/sonar"); }));
  EXPECT_FALSE(state()->motors_on());  // a real robot waits for a person
  ASSERT_TRUE(motors(true));
  EXPECT_TRUE(playUntil([&] { return state()->motors_on(); }));
  EXPECT_TRUE(playUntil([&] {
    const auto packets = ears_.newest<robotcontrol::LinkPackets>("p3at1/link/packets");
    return packets && packets->packets_size() > 0;
  }));
}

TEST_F(PioneerRunTest, stopTakesTheMotorsOff) {
  connect();
  ASSERT_TRUE(playUntil([&] { return connected(); }));
  ASSERT_TRUE(motors(true));
  ASSERT_TRUE(playUntil([&] { return state() && state()->motors_on(); }));
  robotcontrol::Request stop;
  stop.set_robot("p3at1");
  stop.mutable_stop()->set_engaged(true);
  ASSERT_TRUE(run_->request(stop));
  EXPECT_TRUE(playUntil([&] { return !state()->motors_on(); }));
  EXPECT_FALSE(motors(true));
}

TEST_F(PioneerRunTest, afterAStopThatIsReleasedBeforeTheNextStepTheMotorsAreOnAgain) {
  connect();
  ASSERT_TRUE(playUntil([&] { return connected(); }));
  ASSERT_TRUE(motors(true));
  ASSERT_TRUE(playUntil([&] { return state() && state()->motors_on(); }));
  for (const bool engaged : {true, false}) run_->stopSwitch()->engage("p3at1", engaged);
  // Long enough for the commands to have reached the robot and its answers to have come back.
  std::set<std::shared_ptr<const robotcontrol::DriveState>> states;
  ASSERT_TRUE(playUntil([&] { return states.insert(state()).second && states.size() > 10; }));
  EXPECT_TRUE(playUntil([&] { return state()->motors_on(); }));
}

TEST_F(PioneerRunTest, stopActsWhileAProgramHangsAndItsEndIsNotWaitedFor) {
  std::ofstream(layout_)
      << "version: 1\nname: hanging\nhelp: A process that hangs.\n"
         "processes:\n  - {name: stuck, blocking: [drive/state], tasks: [pioneer-run-test: hang]}\n"
         "  - {name: debug, debug: true, period_ms: 16}\n";
  letGo = hangs = false;
  struct AtTheEnd {
    ~AtTheEnd() {
      letGo = true;
      letGo.notify_all();
    }
  } atTheEnd;
  connect();
  ASSERT_TRUE(playUntil([&] { return connected(); }));
  ASSERT_TRUE(motors(true));
  // What the robot does is what counts: a program that hangs answers nothing.
  ASSERT_TRUE(playUntil([&] { return hangs && world_.motorsOn(); }));
  robotcontrol::Request stop;
  stop.set_robot("p3at1");
  stop.mutable_stop()->set_engaged(true);
  ASSERT_TRUE(run_->request(stop));
  EXPECT_TRUE(playUntil([&] { return !world_.motorsOn(); })) << "while it hangs";
  // Whoever ends the run does not wait for the program: the robot is left at once.
  const auto stopSwitch = run_->stopSwitch();
  run_->end();
  EXPECT_FALSE(run_->hasEnded());
  letGo = true;
  letGo.notify_all();
  EXPECT_TRUE(eventually([&] { return run_->hasEnded(); }));
  run_.reset();
  stopSwitch->engage("p3at1", true);  // of a robot that is gone
}

TEST_F(PioneerRunTest, aProgramThatHangsIsNamedAndItsRobotStands) {
  std::ofstream(layout_)
      << "version: 1\nname: hanging\nhelp: A process that hangs.\n"
         "processes:\n  - {name: stuck, blocking: [drive/state], tasks: [pioneer-run-test: hang]}\n"
         "  - {name: debug, debug: true, period_ms: 16}\n";
  letGo = hangs = false;
  auto listeners = ears_.listeners();
  std::string said;
  listeners.hosting = [&](const std::string&, robotlink::Instant, const robotcontrol::HostingStatus& status) {
    said = status.text();
  };
  auto run = RealRun::create(robot(), listeners);
  ASSERT_TRUE(run) << robotlink::describe(run.error());
  run_ = std::move(*run);
  EXPECT_TRUE(playUntil([&] { return said.find("pioneer-run-test (hang) of process stuck") != said.npos; }));
  EXPECT_TRUE(run_->platform().unattended());
  letGo = true;
  letGo.notify_all();
  EXPECT_TRUE(playUntil([&] { return said.find("continues") != said.npos; }));
  EXPECT_FALSE(run_->platform().unattended());
}

TEST_F(PioneerRunTest, aLineThatIsLostIsOpenedAgain) {
  connect();
  ASSERT_TRUE(playUntil([&] { return connected(); }));
  world_.unplug(true);
  ASSERT_TRUE(playUntil([&] { return !connected(); }));
  EXPECT_TRUE(playUntil([&] {
    const auto status = ears_.newest<robotcontrol::LinkStatus>("p3at1/link/status");
    return status && status->state() == robotcontrol::LinkStatus::LOST && !status->text().empty();
  }));
  world_.unplug(false);
  EXPECT_TRUE(playUntil([&] { return connected(); }));
}

TEST_F(PioneerRunTest, anotherLayoutLeavesTheRobotConnected) {
  connect();
  ASSERT_TRUE(playUntil([&] { return connected(); }));
  EXPECT_TRUE(run_->setLayout(layout_).empty());
  EXPECT_FALSE(run_->setLayout("no-such-layout.yaml").empty());
  run_->step();
  EXPECT_TRUE(connected());
}

TEST_F(PioneerRunTest, whatAPersonChoseIsKeptByAnotherLayoutOrSaidToBeLost) {
  connect();
  const auto driving = [&] {
    const auto table = ears_.newest<robotcontrol::SolutionTable>("p3at1/tables/solutions");
    for (int i = 0; table && i < table->tasks_size(); ++i) {
      if (table->tasks(i).name() == "driving") return table->tasks(i).active();
    }
    return std::string();
  };
  ASSERT_TRUE(run_->setLayout(robotlink::resource("layouts/pioneer.yaml")).empty());
  robotcontrol::Request request;
  request.set_id(1);
  request.set_robot("p3at1");
  request.mutable_select_solution()->set_task("driving");
  request.mutable_select_solution()->set_solution("wander");
  ASSERT_TRUE(run_->request(request));
  ASSERT_TRUE(playUntil([&] { return driving() == "wander"; }));
  ASSERT_TRUE(run_->setLayout(robotlink::resource("layouts/pioneer-parallel.yaml")).empty());
  EXPECT_TRUE(run_->lostChoices().empty());
  ears_.forget();
  EXPECT_TRUE(playUntil([&] { return driving() == "wander"; }));
  ASSERT_TRUE(run_->setLayout(layout_).empty());
  EXPECT_EQ(run_->lostChoices(),
            std::vector<std::string>{"p3at1 could not keep solution wander of task driving: "
                                     "no process of this layout has 'driving'"});
}

TEST_F(PioneerRunTest, whatIsWrongWithItIsSaidBeforeAnythingRuns) {
  auto run = RealRun::create(pioneerOptions("pigeon://home"), {});
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().front().id, "url.bad");
  RealRobotOptions lost = robot();
  lost.program.map = "no-such.map";
  run = RealRun::create(lost, {});
  ASSERT_FALSE(run);
}
