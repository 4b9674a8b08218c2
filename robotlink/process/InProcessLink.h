// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>

#include "robotlink/process/EndOwner.h"
#include "robotlink/process/Link.h"

namespace robotlink {

/// A link between two processes of one program. It passes the pointer on and never copies the package. Both
/// processes must live until close() has returned; after that the link is inert. Thread-safe as Link
/// requires; take() costs one atomic read when nothing has arrived.
class InProcessLink final : public Link {
 public:
  InProcessLink(EndOwner& sender, EndOwner& receiver) : sender_(sender), receiver_(receiver) {}

  void offer(PackagePtr package) override;
  bool delivered() const override { return !kept_.load(std::memory_order_acquire); }
  PackagePtr take() override;
  void close() override;
  bool closed() const override { return closed_.load(std::memory_order_acquire); }
  std::uint64_t missed() const override { return missed_.load(std::memory_order_relaxed); }

 private:
  EndOwner& sender_;
  EndOwner& receiver_;
  // Protects inbox_, pending_ and closed_. Held while a process is woken, so that close() waits for that.
  std::mutex mutex_;
  /// The package that was delivered and not yet taken.
  PackagePtr inbox_;
  /// The package that was offered while inbox_ was full; replaced by newer packages.
  PackagePtr pending_;
  // The atomics mirror the state for readers without the lock.
  std::atomic<bool> closed_{false};
  /// Whether pending_ is not null.
  std::atomic<bool> kept_{false};
  /// Whether inbox_ is not null.
  std::atomic<bool> filled_{false};
  /// How often a newer package replaced one that was never taken.
  std::atomic<std::uint64_t> missed_{0};
};

}  // namespace robotlink
