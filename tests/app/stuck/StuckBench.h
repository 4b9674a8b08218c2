// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/PlatformThread.h"
#include "app/core/program/Abandoned.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"
#include "tests/Eventually.h"
#include "tests/app/stuck/StuckSolution.h"

namespace app::test {

/// Two robots whose program has a module that hangs, on a platform as the window runs it.
class StuckBench {
 public:
  StuckBench() {
    StuckSolution::prepare(false);
    session_.setRequestSink([this](const robotcontrol::Request& request) { thread_->request(request); });
  }
  ~StuckBench() {
    StuckSolution::release();
    thread_.reset();
    EXPECT_TRUE(eventually([] { return abandonedCount() == 0; }));
  }

 protected:
  void open(PlatformOpening opening) {
    std::atomic<bool> isLoaded{false};
    thread_->open(std::move(opening), {}, [&](const auto& loaded) {
      EXPECT_TRUE(loaded) << robotlink::describe(loaded.error());
      if (loaded)
        for (const auto& [name, robot] : loaded->robots) robots_.push_back(name);
      isLoaded = true;
    });
    EXPECT_TRUE(eventually([&] { return isLoaded.load(); }));
  }
  /// Whether the session meets a condition in time.
  template <typename Condition>
  bool soon(Condition condition) {
    return eventually([&] {
      session_.tick();
      return condition();
    });
  }
  /// The newest message of a path; null if there is none.
  template <typename T>
  const T* latest(const std::string& path) {
    return session_.store().latestAs<T>(path, robotlink::Instant::max());
  }
  const robotcontrol::HostingStatus* hosting(const std::string& robot) {
    return latest<robotcontrol::HostingStatus>(robot + "/hosting");
  }
  /// The robot whose program does not return; empty: all do.
  std::string stuckRobot() {
    for (const std::string& robot : robots_) {
      const auto* status = hosting(robot);
      if (status != nullptr && status->state() == robotcontrol::HostingStatus::NOT_ANSWERING) return robot;
    }
    return {};
  }
  /// Asks for something; returns "accepted", or the reason why not.
  std::string ask(robotcontrol::Request request) {
    std::optional<std::string> answer;
    session_.request(std::move(request), [&](const robotcontrol::RequestResult& result) {
      answer = result.accepted() ? "accepted" : result.reason();
    });
    EXPECT_TRUE(soon([&] { return answer.has_value(); }));
    return answer.value_or("no answer");
  }
  /// Lets a module hang in a platform that runs; returns the robot whose program it is.
  std::string hangNow() {
    StuckSolution::shallHang = true;
    EXPECT_TRUE(soon([&] { return !stuckRobot().empty(); }));
    return stuckRobot();
  }
  void expectThatItClosesWhileOneHangs() {
    std::atomic<bool> isClosed{false};
    thread_->close([&](const auto&) { isClosed = true; });
    EXPECT_TRUE(eventually([&] { return isClosed.load(); }));
    EXPECT_EQ(StuckSolution::hanging, 1);
    EXPECT_EQ(abandonedCount(), 1);
  }

  robotlink::Session session_;
  logplayer::Recorder recorder_{{}};
  std::vector<std::string> robots_;
  std::unique_ptr<PlatformThread> thread_ = std::make_unique<PlatformThread>(session_, recorder_);
};

}  // namespace app::test
