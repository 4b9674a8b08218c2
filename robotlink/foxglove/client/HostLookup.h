// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink::websocket {

/// Finds the IP addresses of a host. The system may take many seconds for a name, and cannot be interrupted:
/// it is asked in a thread of its own that nobody waits for.
class HostLookup {
 public:
  using Outcome = Result<std::vector<std::string>>;

  /// Addresses, and localhost, are known at once.
  static std::shared_ptr<HostLookup> start(const std::string& host);

  /// Nothing while the system is being asked. Any thread.
  std::optional<Outcome> outcome() const;

 private:
  void finish(Outcome outcome);

  /// Protects what follows.
  mutable std::mutex mutex_;
  std::optional<Outcome> outcome_;
};

}  // namespace robotlink::websocket
