// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated robots, steered by a client of the WebSocket protocol that is not heard any more. Real time is a
// manual clock that goes with the simulation.
#include <gtest/gtest.h>

#include "app/platforms/simulated/SimulatedRun.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/session/SessionServer.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotcontrol::Request;
namespace link = robotlink::websocket;

/// A simulation that is served, and one client without a socket.
class SteeredRun {
 public:
  SteeredRun(RunOptions options, std::string robot) : robot_(std::move(robot)) {
    SimulatedRun::Listeners listeners;
    listeners.queue = [this](const std::string& name, auto queue) { session_.pushQueue(name, queue); };
    run_ = std::move(SimulatedRun::create(std::move(options), listeners).value());
    session_.setRobots(run_->robots());
    session_.setRequestSink([this](const Request& request) { fulfill(request); });
    link::ServerOptions serving;
    serving.clock = clock_;
    server_ = std::make_unique<link::SessionServer>(session_, serving);
    client_ = *server_->server()->connect({0, "10.0.0.1:1", "test"}, [] {});
    say(link::ClientAdvertise{{{1, robot_ + "/remote/drive", "json", "", "", ""}}});
  }
  ~SteeredRun() { server_.reset(); }
  SteeredRun(const SteeredRun&) = delete;
  SteeredRun& operator=(const SteeredRun&) = delete;

  void drive(const std::string& velocity) { say(link::ClientMessageData{1, velocity}); }
  /// Lets time pass, in which the client is heard or not.
  void pass(robotlink::Duration time, bool isHeard = true) {
    const auto end = clock_->now() + time;
    while (clock_->now() < end) {
      clock_->advance(SimulatedWorld::kStep);
      if (isHeard) client_->heardAt = clock_->now().time_since_epoch().count();
      session_.tick();
      server_->tick();
      run_->step();
    }
  }
  /// Drives for so long, with a command every 0.1 s.
  void driveFor(robotlink::Duration time, const std::string& velocity) {
    for (auto end = clock_->now() + time; clock_->now() < end; pass(100ms)) drive(velocity);
  }
  robotlink::Vector2 place() {
    return robotlink::groundPose(run_->world().simulation().modelPose(robot_).value()).translation();
  }
  link::SessionServer& server() { return *server_; }
  void end() { server_->server()->disconnected(client_); }

 private:
  void say(const link::ClientMessage& message) {
    const link::Frame frame = link::encode(message);
    server_->server()->received(client_, frame.kind, frame.bytes);
  }
  void fulfill(const Request& request) {
    const auto done = run_->request(request);
    if (done && robotlink::kindOf(request).isOfProgram()) return;
    robotcontrol::RequestResult result;
    result.set_id(request.id());
    result.set_accepted(done.has_value());
    if (!done) result.set_reason(done.error().text);
    session_.pushResult(result);
  }

  const std::string robot_;
  const std::shared_ptr<robotlink::ManualClock> clock_ = std::make_shared<robotlink::ManualClock>();
  robotlink::Session session_;
  std::unique_ptr<SimulatedRun> run_;
  std::unique_ptr<link::SessionServer> server_;
  link::ClientPtr client_;
};

RunOptions soccerRobot() {
  RunOptions options = defaultSimulation();
  options.solutions["behavior"] = "obey";
  return options;
}

RunOptions pioneerScene() {
  RunOptions options = defaultSimulation();
  options.scene = robotlink::resource("scenes/pioneer.sdf");
  options.solutions["driving"] = "obey";
  return options;
}

struct Steered {
  const char* name;
  RunOptions (*options)();
  const char* robot;
  /// How far it gets in 3 s at least, and how long it takes to stand, as it walks or rolls.
  double way;
  robotlink::Duration settle;
};

class ServedSteering : public testing::TestWithParam<Steered> {
 protected:
  SteeredRun run_{GetParam().options(), GetParam().robot};
  void expectStanding(bool isHeard) {
    run_.pass(GetParam().settle, isHeard);
    const auto stands = run_.place();
    run_.pass(3s, isHeard);
    EXPECT_LT((run_.place() - stands).norm(), 0.02);
  }
  void expectDriving() {
    const auto start = run_.place();
    run_.driveFor(3s, R"({"velocity": {"x": 0.1}})");
    EXPECT_GT((run_.place() - start).norm(), GetParam().way);
  }
};

TEST_P(ServedSteering, theRobotStandsWhenNoMotionComesAnyMore) {
  run_.pass(1s);
  expectDriving();
  expectStanding(true);
  // The person is there again.
  expectDriving();
}

TEST_P(ServedSteering, theRobotStandsWhileTheLinkIsSilentAndGoesOnAfterwards) {
  run_.pass(1s);
  for (int i = 0; i < 2; ++i) {
    expectDriving();
    expectStanding(false);
  }
  expectDriving();
  run_.end();
  expectStanding(false);
}

INSTANTIATE_TEST_SUITE_P(Robots, ServedSteering,
                         testing::Values(Steered{"ers210", soccerRobot, "red1", 0.15, 2s},
                                         Steered{"pioneer", pioneerScene, "p3at1", 0.2, 1500ms}),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace app
