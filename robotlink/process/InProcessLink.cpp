// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/InProcessLink.h"

namespace robotlink {

void InProcessLink::offer(PackagePtr package) {
  const std::lock_guard lock(mutex_);
  if (closed()) return;
  if (inbox_) {
    if (pending_) missed_.fetch_add(1, std::memory_order_relaxed);
    pending_ = std::move(package);
    kept_.store(true, std::memory_order_release);
    return;
  }
  inbox_ = std::move(package);
  filled_.store(true, std::memory_order_release);
  receiver_.wake();
}

PackagePtr InProcessLink::take() {
  if (!filled_.load(std::memory_order_acquire)) return nullptr;
  const std::lock_guard lock(mutex_);
  PackagePtr newest = std::move(inbox_);
  inbox_ = nullptr;
  filled_.store(false, std::memory_order_release);
  if (!pending_) return newest;
  // After taking the first package, the receiver is ready for the second and takes that, too.
  newest = std::move(pending_);
  pending_ = nullptr;
  kept_.store(false, std::memory_order_release);
  missed_.fetch_add(1, std::memory_order_relaxed);
  if (!closed()) sender_.wake();
  return newest;
}

void InProcessLink::close() {
  const std::lock_guard lock(mutex_);
  if (closed()) return;
  closed_.store(true, std::memory_order_release);
  pending_ = nullptr;
  kept_.store(false, std::memory_order_release);
  sender_.wake();  // The sender may have been waiting for the receiver.
}

}  // namespace robotlink
