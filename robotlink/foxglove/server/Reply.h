// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "robotlink/base/Error.h"

namespace robotlink::websocket {

/// Answers a request of a client, now or later, from any thread. The first answer counts; a request whose
/// last copy of this goes without one has failed. Answers to clients that are gone are dropped.
class Reply {
 public:
  struct Answer {
    std::string data;
    /// The encoding of the data; empty: that of the request.
    std::string encoding;
  };
  using Send = std::function<void(Result<Answer>)>;

  explicit Reply(Send send) : pending_(std::make_shared<Pending>(std::move(send))) {}

  void succeed(std::string data = {}, std::string encoding = {}) const {
    pending_->finish(Answer{std::move(data), std::move(encoding)});
  }
  /// Fails with a sentence for the user who asked.
  void fail(std::string reason) const { pending_->finish(failure("foxglove.request", std::move(reason))); }

 private:
  struct Pending {
    explicit Pending(Send function) : send(std::move(function)) {}
    ~Pending() { finish(failure("foxglove.request", "the robot gave no answer")); }
    Pending(const Pending&) = delete;
    Pending& operator=(const Pending&) = delete;
    void finish(Result<Answer> result) {
      if (!isFinished.exchange(true)) send(std::move(result));
    }

    const Send send;
    std::atomic<bool> isFinished{false};
  };

  std::shared_ptr<Pending> pending_;
};

}  // namespace robotlink::websocket
