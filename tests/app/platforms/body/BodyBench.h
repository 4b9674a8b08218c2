// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "app/platforms/body/BodyFeed.h"
#include "app/platforms/body/BodyProgram.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "tests/Eventually.h"
#include "tests/app/served/ServedHall.h"

namespace app::test {

inline RunOptions bodies(const std::string& scene, const std::shared_ptr<BodyInbox>& inbox) {
  RunOptions options = defaultSimulation();
  options.scene = robotlink::resource(scene);
  options.instead = BodyProgram::maker({.inbox = inbox});
  return options;
}

/// The bodies of a scene, offered at a port of this machine.
class OfferedBodies {
 public:
  explicit OfferedBodies(const std::string& scene, const AccessOptions& access = {})
      : hall_({.access = access, .bodies = inbox_}, SimulationFeed::opening(bodies(scene, inbox_))) {}
  std::uint16_t port() const { return hall_.port(); }

 private:
  const std::shared_ptr<BodyInbox> inbox_ = std::make_shared<BodyInbox>();
  ServedHall hall_;
};

inline std::string urlOf(std::uint16_t port) {
  return "ws://127.0.0.1:" + std::to_string(port);
}

/// A program here for a body there, stepped by the test, and somebody at the body who watches it.
class BodyDesk {
 public:
  BodyDesk(BodyOptions options, std::uint16_t bodyPort) : watcher_(watching(bodyPort)) {
    options.patience = std::chrono::seconds(30);
    session_.addListener({[this](const robotlink::StreamMessage& message) { note(message); }, {}});
    auto feed = BodyFeed::create(std::move(options), session_, recorder_);
    EXPECT_TRUE(feed) << robotlink::describe(feed.error());
    if (!feed) return;
    feed_ = std::move(*feed);
    feed_->begin();
  }

  template <typename Condition>
  bool soon(Condition condition) {
    if (!feed_) return false;
    return eventually([&] {
      feed_->step();
      session_.tick();
      watcher_.tick();
      if (const auto arrived = watcher_.take(); arrived.state) state_ = arrived.state;
      return condition();
    });
  }
  template <typename T>
  const T* newest(const std::string& path) {
    return session_.store().latestAs<T>(path, robotlink::Instant::max());
  }
  void ask(robotcontrol::Request request) {
    request.set_robot(feed_->describe().robots.begin()->first);
    const auto done = feed_->fulfill(request);
    EXPECT_TRUE(done) << done.error().text;
  }
  /// Makes a package of the program visible.
  void show(const std::string& package) {
    robotcontrol::Request request;
    request.mutable_set_key()->set_name("package/" + package);
    request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    ask(request);
  }
  /// What somebody at the body sees.
  bool bodyStands() const { return state_ && state_->stands(); }
  bool bodyMoves() const { return state_ && !state_->stands(); }
  bool bodyIsStopped() const { return state_ && state_->stop_engaged(); }
  bool said(const std::string& text) const { return texts_.find(text) != std::string::npos; }
  void forgetTexts() { texts_.clear(); }
  /// Somebody at the body presses STOP, or releases it.
  void stopAtBody(bool engaged) {
    watcher_.engageStop(engaged, [](const std::string&) {});
  }
  BodyFeed& feed() { return *feed_; }

 private:
  static BodyLink::Options watching(std::uint16_t port) {
    BodyLink::Options options;
    options.connection.url = *robotlink::websocket::parseServerUrl(urlOf(port));
    return options;
  }
  void note(const robotlink::StreamMessage& message) {
    if (const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get()))
      texts_ += text->message() + "\n";
  }

  robotlink::Session session_;
  logplayer::Recorder recorder_{{}};
  BodyLink watcher_;
  std::shared_ptr<const robotcontrol::BodyState> state_;
  std::string texts_;
  std::unique_ptr<BodyFeed> feed_;
};

}  // namespace app::test
