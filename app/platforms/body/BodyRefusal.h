// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <utility>

#include "robotlink/base/Error.h"

namespace app {

/// Passes the reason why an open body refuses the connection from the platform's thread to the GUI's. Any
/// thread.
class BodyRefusal {
 public:
  /// Empty: it does not refuse.
  void set(robotlink::Errors why) {
    const std::lock_guard lock(mutex_);
    why_ = std::move(why);
  }
  robotlink::Errors get() const {
    const std::lock_guard lock(mutex_);
    return why_;
  }

 private:
  /// Protects why_.
  mutable std::mutex mutex_;
  robotlink::Errors why_;
};

}  // namespace app
