// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotlink::websocket {

/// The fields of an HTTP upgrade request that matter for admission. Missing fields are empty.
struct Knock {
  bool isWebSocket = false;
  /// The machine that asks, without its port.
  std::string address;
  std::string protocols, origin, authorization, target;
};

/// The refusal of a request: the status of the HTTP answer, and its text.
struct Refusal {
  unsigned status = 400;
  std::string sentence;
  /// Whether a wrong token was shown, or none.
  bool isWrongToken = false;
};

/// The terms on which a client may connect.
struct Admitted {
  /// The sub-protocol to speak.
  std::string protocol;
  /// Whether it showed the token of those who may only watch.
  bool isReadOnly = false;
};

/// Decides who may connect. A wrong token makes its machine wait: until then nothing from it is decided,
/// right or wrong, so that guessing is slow however many connections guess. Not thread-safe.
class Admission {
 public:
  struct Options {
    /// The token for full control, which clients show as "Authorization: Bearer TOKEN" or, if headers cannot
    /// be set, as ?token=TOKEN behind the URL. If this and watchToken are empty: none is needed.
    std::string token = {};
    /// The origins ("https://example.org") whose web pages may connect, or "*" for all. Programs that are no
    /// browsers state none.
    std::vector<std::string> origins = {};
    Duration wrongTokenDelay = std::chrono::seconds(1);
    /// The token of clients that may only watch; empty: there are none.
    std::string watchToken = {};
  };

  explicit Admission(Options options) : options_(std::move(options)) {}

  /// When a request of this machine may be decided.
  Instant decidableAt(const std::string& address) const;
  std::variant<Admitted, Refusal> decide(const Knock& knock, Instant now);

 private:
  bool showsToken(const Knock& knock, const std::string& token) const;

  const Options options_;
  /// Machines that showed a wrong token, and until when they wait.
  std::map<std::string, Instant> waiting_;
};

}  // namespace robotlink::websocket
