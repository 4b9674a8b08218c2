// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>

#include "app/core/ServedPlatform.h"
#include "app/core/body/BodyFeed.h"
#include "app/core/body/BodyProgram.h"
#include "app/core/simulated/SimulationFeed.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "tests/Eventually.h"

namespace app::test {

/// Prints until the port is known.
class PortLine : public std::stringbuf {
 public:
  std::uint16_t wait() { return port_.get_future().get(); }

 protected:
  int sync() override {
    const std::string text = str();
    const std::size_t address = text.find("ws://");
    if (isTold_ || address == std::string::npos || text.find('\n', address) == std::string::npos) return 0;
    isTold_ = true;
    port_.set_value(static_cast<std::uint16_t>(std::stoi(text.substr(text.find(':', address + 5) + 1))));
    return 0;
  }

 private:
  std::promise<std::uint16_t> port_;
  bool isTold_ = false;
};

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
      : served_(std::async(std::launch::async,
                           [this, scene, access] {
                             return serve(
                                 SimulationFeed::opening(bodies(scene, inbox_)),
                                 {.address = {"127.0.0.1", 0}, .access = access, .bodies = inbox_}, recorder_,
                                 [this] { return isOver_.load(); }, out_);
                           })),
        port_(printed_.wait()) {}
  ~OfferedBodies() {
    isOver_ = true;
    EXPECT_TRUE(served_.get().empty());
  }
  std::uint16_t port() const { return port_; }

 private:
  const std::shared_ptr<BodyInbox> inbox_ = std::make_shared<BodyInbox>();
  PortLine printed_;
  std::ostream out_{&printed_};
  logplayer::Recorder recorder_{{}};
  std::atomic<bool> isOver_{false};
  std::future<robotlink::Errors> served_;
  std::uint16_t port_;
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
    const auto done = feed_->fulfil(request);
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
