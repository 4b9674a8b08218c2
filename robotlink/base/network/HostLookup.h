// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotlink {

/// Finds the IP addresses of a host. The system may take many seconds for a name, and cannot be interrupted:
/// it is asked in a separate thread, which ends by itself when no one waits for it any longer.
class HostLookup {
 public:
  /// The addresses as text, at least one, those to be tried first at the front.
  using Outcome = Result<std::vector<std::string>>;
  /// Finds the addresses, and may block for long; called in the thread.
  using Resolver = std::function<Outcome(const std::string& host)>;

  /// IP addresses are known at once, as is localhost. Without a resolver the system is asked.
  static std::shared_ptr<HostLookup> start(const std::string& host, Resolver resolver = {});

  /// Returns nothing while the name is being looked up. Any thread.
  std::optional<Outcome> outcome() const;
  /// The same after waiting for it, for at most `limit`.
  std::optional<Outcome> wait(Duration limit) const;

 private:
  void finish(Outcome outcome);

  /// Protects the outcome.
  mutable std::mutex mutex_;
  /// Signaled when there is one.
  mutable std::condition_variable finished_;
  std::optional<Outcome> outcome_;
};

}  // namespace robotlink
