// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/InProcessLink.h"

#include "robotlink/process/Process.h"

namespace robotlink {

void InProcessLink::offer(PackagePtr package) {
  bool arrived = false;
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    if (!inbox_) {
      inbox_ = std::move(package);
      filled_.store(true, std::memory_order_release);
      arrived = true;
    } else {
      if (pending_) missed_.fetch_add(1, std::memory_order_relaxed);
      pending_ = std::move(package);
      kept_.store(true, std::memory_order_release);
    }
  }
  if (arrived) receiver_.wake();
}

PackagePtr InProcessLink::take() {
  if (!filled_.load(std::memory_order_acquire)) return nullptr;
  PackagePtr newest;
  bool freed = false;
  {
    const std::lock_guard lock(mutex_);
    newest = std::move(inbox_);
    inbox_ = nullptr;
    filled_.store(false, std::memory_order_release);
    if (pending_) {  // Having taken the first, the receiver asks, is given the second, and takes that, too.
      newest = std::move(pending_);
      pending_ = nullptr;
      kept_.store(false, std::memory_order_release);
      missed_.fetch_add(1, std::memory_order_relaxed);
      freed = true;
    }
  }
  if (freed) sender_.wake();
  return newest;
}

void InProcessLink::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    inbox_ = nullptr;
    pending_ = nullptr;
    filled_.store(false, std::memory_order_release);
    kept_.store(false, std::memory_order_release);
  }
  sender_.wake();
}

}  // namespace robotlink
