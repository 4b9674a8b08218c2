// SPDX-License-Identifier: GPL-3.0-or-later
// Modules that never return, in programs that run on a log in the workbench: everything else goes on.
#include <gmock/gmock.h>

#include <atomic>
#include <fstream>

#include "app/core/PlatformThread.h"
#include "app/core/program/Abandoned.h"
#include "app/core/replay/ReplayFeed.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "simcore/Scene.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/replay/ReplayFixture.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotcontrol::ControlReplay;
using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;
using robotcontrol::ReplayStatus;
using robotcontrol::Request;
using testing::HasSubstr;

/// Whether the next module that is executed is to hang; and whether those that do may go on.
std::atomic<bool> logShallHang{false}, isLogLetGo{false};
std::atomic<int> logHanging{0};

/// Loops until the test releases it.
class StuckOnLog final : public robotlink::Solution {
 public:
  explicit StuckOnLog(robotlink::SolutionContext& context)
      : joints_(context.input(robotlink::kJointStates)) {}
  void execute() override {
    if (!logShallHang.exchange(false)) return;
    ++logHanging;
    isLogLetGo.wait(false);
    --logHanging;
  }

 private:
  robotlink::Input<foxglove::JointStates> joints_;
};
// It yields a package that no log has, so that it runs on logs.
const robotlink::SolutionRegistration kStuckOnLog =
    robotlink::SolutionBuilder<StuckOnLog>("stuck-replay-test", "hang", "Never returns.")
        .needs(robotlink::kJointStates)
        .yields(robotlink::kDrivePath);

/// A log of two robots, as the window runs it.
class StuckReplayTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TestFolder>();
    RunOptions options = defaultSimulation();
    options.layout = robotlink::resource("layouts/compact.yaml");
    options.world.blackout = true;
    options.robots = simcore::RobotsToAdd{.model = "ers210", .count = 1};
    test::recordSimulation(*folder_ / "two.mcap", options, 250);
    std::ofstream(*folder_ / "hanging.yaml")
        << "version: 1\nname: hanging\nhelp: A process that hangs.\n"
           "processes:\n"
           "  - {name: stuck, blocking: [joints/states], tasks: [stuck-replay-test: hang]}\n"
           "  - {name: debug, debug: true, period_ms: 16}\n";
  }
  static void TearDownTestSuite() { folder_.reset(); }

  StuckReplayTest() {
    logShallHang = isLogLetGo = false;
    thread_ = std::make_unique<PlatformThread>(session_, recorder_);
    session_.setRequestSink([this](const Request& request) { thread_->request(request); });
    ReplayOptions options = test::replayOf({{*folder_ / "two.mcap"}});
    options.layout = *folder_ / "hanging.yaml";
    options.patience = 200ms;
    std::atomic<bool> isLoaded{false};
    thread_->open(ReplayFeed::opening(options), {}, [&](const auto& loaded) {
      EXPECT_TRUE(loaded) << robotlink::describe(loaded.error());
      if (loaded)
        for (const auto& [name, robot] : loaded->robots) robots_.push_back(name);
      isLoaded = true;
    });
    EXPECT_TRUE(eventually([&] { return isLoaded.load(); }));
  }
  ~StuckReplayTest() override {
    release();
    thread_.reset();
    EXPECT_TRUE(eventually([] { return abandonedCount() == 0; }));
  }
  static void release() {
    isLogLetGo = true;
    isLogLetGo.notify_all();
  }
  template <typename Condition>
  bool soon(Condition condition) {
    return eventually([&] {
      session_.tick();
      return condition();
    });
  }
  const HostingStatus* hosting(const std::string& robot) {
    return session_.store().latestAs<HostingStatus>(robot + "/hosting", robotlink::Instant::max());
  }
  std::int64_t time() {
    const auto* status = session_.store().latestAs<ReplayStatus>("replay", robotlink::Instant::max());
    return status == nullptr ? 0 : status->time();
  }
  std::string stuckRobot() {
    for (const std::string& robot : robots_) {
      const HostingStatus* status = hosting(robot);
      if (status != nullptr && status->state() == HostingStatus::NOT_ANSWERING) return robot;
    }
    return {};
  }
  std::string ask(Request request) {
    std::optional<std::string> answer;
    session_.request(std::move(request), [&](const robotcontrol::RequestResult& result) {
      answer = result.accepted() ? "accepted" : result.reason();
    });
    EXPECT_TRUE(soon([&] { return answer.has_value(); }));
    return answer.value_or("no answer");
  }
  std::string act(ControlReplay::Action action, std::int64_t value = 0) {
    Request request;
    auto& control = *request.mutable_control_replay();
    control.set_action(action);
    if (action == ControlReplay::JUMP_TO_TIME) control.set_time(value);
    if (action == ControlReplay::PLAY) control.set_loop(true);
    return ask(request);
  }
  std::string hang() {
    EXPECT_EQ(act(ControlReplay::PLAY), "accepted");
    logShallHang = true;
    EXPECT_TRUE(soon([&] { return !stuckRobot().empty(); }));
    return stuckRobot();
  }
  bool timeGoesOn() {
    const auto before = time();
    return soon([&] { return time() != before; });
  }

  static inline std::unique_ptr<TestFolder> folder_;
  robotlink::Session session_;
  logplayer::Recorder recorder_{{}};
  std::vector<std::string> robots_;
  std::unique_ptr<PlatformThread> thread_;
};

TEST_F(StuckReplayTest, itIsNamedAndTheOtherRobotsGoOn) {
  ASSERT_EQ(robots_.size(), 2U);
  const std::string robot = hang();
  EXPECT_THAT(hosting(robot)->text(), HasSubstr("stuck-replay-test (hang) of process stuck"));
  EXPECT_TRUE(timeGoesOn());
  Request key;
  key.set_robot(robot);
  key.mutable_set_key()->set_name("timing/tasks");
  EXPECT_THAT(ask(key), HasSubstr("does not return"));
  for (const std::string& other : robots_) {
    if (other == robot) continue;
    key.set_robot(other);
    EXPECT_EQ(ask(key), "accepted");
  }
  EXPECT_EQ(act(ControlReplay::PAUSE), "accepted");
}

TEST_F(StuckReplayTest, whenItReturnsTheProgramGoesOn) {
  const std::string robot = hang();
  release();
  EXPECT_TRUE(soon([&] {
    const auto* status = hosting(robot);
    return status != nullptr && status->state() == HostingStatus::RUNNING;
  }));
  EXPECT_TRUE(timeGoesOn());
}

TEST_F(StuckReplayTest, jumpsAndStartAgainWorkWhileItHangs) {
  hang();
  EXPECT_EQ(act(ControlReplay::PAUSE), "accepted");
  EXPECT_EQ(act(ControlReplay::JUMP_TO_TIME, 0), "accepted");
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
  EXPECT_EQ(logHanging, 1);
  const std::string robot = hang();
  Request again;
  again.set_robot(robot);
  again.mutable_host_program()->set_start_again(true);
  EXPECT_EQ(ask(again), "accepted");
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
  EXPECT_EQ(logHanging, 2);
  EXPECT_TRUE(timeGoesOn());
  again.mutable_host_program()->set_executor(HostProgram::THREADS);
  EXPECT_THAT(ask(again), HasSubstr("programs on logs run in lockstep"));
}

TEST_F(StuckReplayTest, theLogIsClosedWhileItHangs) {
  hang();
  std::atomic<bool> isClosed{false};
  thread_->close([&](const auto&) { isClosed = true; });
  EXPECT_TRUE(eventually([&] { return isClosed.load(); }));
  EXPECT_EQ(logHanging, 1);
  EXPECT_EQ(abandonedCount(), 1);
}

TEST_F(StuckReplayTest, whatRunsIsEndedWhileItHangs) {
  hang();
  thread_.reset();
  EXPECT_EQ(logHanging, 1);
}

}  // namespace
}  // namespace app
