// SPDX-License-Identifier: GPL-3.0-or-later
// Several connections at once: which of them the world is of.
#include "app/core/remote/RemoteRobots.h"

#include <gtest/gtest.h>

#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "robotlink/session/Session.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotlink::Instant;
namespace websocket = robotlink::websocket;

std::unique_ptr<websocket::Listener> openPort(const std::shared_ptr<websocket::Server>& server) {
  websocket::Listener::Options options;
  options.address.port = 0;
  options.greetingDelay = robotlink::Duration::zero();
  return *websocket::Listener::open(server, options);
}

std::string addressOf(const websocket::Listener& listener) {
  return "ws://127.0.0.1:" + std::to_string(listener.address().port);
}

/// A simulation that is offered, and a server that knows nothing of sessions.
class RemoteRobotsTest : public testing::Test {
 protected:
  void tick() {
    channel_->publish(Instant(1000s), R"({"volts": 11.5})");
    hall_.push({"scene", Instant(5s), std::make_shared<foxglove::SceneUpdate>()});
    hall_.push({"red1/log", Instant(5s), std::make_shared<foxglove::Log>()});
    hall_.push({"simulation", Instant(5s), std::make_shared<robotcontrol::SimulationStatus>()});
    hall_.tick();
    server_.tick();
    robots_.tick();
    session_.tick();
  }
  template <typename Condition>
  bool soon(Condition condition) {
    return eventually([&] {
      tick();
      return condition();
    });
  }
  bool has(const std::string& path) { return session_.store().find(path) != nullptr; }

  const TestFolder folder_;
  std::shared_ptr<websocket::Server> foreign_ = websocket::Server::make({.name = "bridge"}, {});
  websocket::ChannelPtr channel_ = foreign_->addChannels(
      {{"/battery", "json", "Battery", R"({"type":"object","properties":{"volts":{"type":"number"}}})",
        "jsonschema"}})[0];
  robotlink::Session hall_;
  websocket::SessionServer server_{hall_};
  std::unique_ptr<websocket::Listener> foreignPort_ = openPort(foreign_),
                                       hallPort_ = openPort(server_.server());
  robotlink::Session session_;
  logplayer::Recorder recorder_{logplayer::Recorder::Options{}};
  LinkLimitsMemory limits_{folder_.path() / "limits"};
  RemoteRobots robots_{session_, recorder_, limits_};
};

TEST_F(RemoteRobotsTest, aSimulationIsShownAlsoIfAForeignServerWasConnectedBefore) {
  hall_.setRobots({"red1"});
  ASSERT_TRUE(robots_.connect(addressOf(*foreignPort_)));
  ASSERT_TRUE(soon([&] { return has("bridge/battery"); }));
  ASSERT_TRUE(robots_.connect(addressOf(*hallPort_)));
  EXPECT_TRUE(soon([&] { return has("scene") && has("simulation"); }));
  robotcontrol::Request pause;
  pause.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::PAUSE);
  EXPECT_TRUE(robots_.take(pause));
  EXPECT_GE(session_.store().newest(), Instant(1000s)) << "the session's time goes on";
  ASSERT_TRUE(robots_.disconnect(addressOf(*hallPort_)));
  EXPECT_TRUE(soon([&] { return !robots_.take(pause); }));
}

}  // namespace
}  // namespace app
