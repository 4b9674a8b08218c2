// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "robotlink/base/Error.h"

namespace app {

/// Calls a service of a robot with an argument in JSON; the handler is called once, from any thread. An error
/// with the id robotlink::websocket::kServiceFailure is the robot's answer; others are those of the line.
using ServiceCall = std::function<void(const std::string& service, const std::string& argument,
                                       std::function<void(robotlink::Result<std::string>)> handler)>;

/// An answer that arrives later.
class PendingAnswer {
 public:
  using Answer = robotlink::Result<std::string>;

  PendingAnswer(const ServiceCall& call, const std::string& service, const std::string& argument) {
    const auto promise = std::make_shared<std::promise<Answer>>();
    future_ = promise->get_future();
    call(service, argument, [promise](Answer answer) { promise->set_value(std::move(answer)); });
  }
  /// Empty if `proceed`, which is called ten times a second, returned false before it arrived.
  std::optional<Answer> wait(const std::function<bool()>& proceed) {
    while (future_.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
      if (!proceed()) return std::nullopt;
    }
    return future_.get();
  }

 private:
  std::future<Answer> future_;
};

}  // namespace app
