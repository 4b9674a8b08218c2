// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>

#include "robotlink/process/EndOwner.h"
#include "robotlink/process/Link.h"

namespace robotlink {

/// A link between two processes of one program. Hands the pointer over; never copies the package.
/// Until close() has returned both processes must live; after that it is only a place where nothing arrives.
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
  // Protects inbox_, pending_ and closed_, and is held while a process is woken: close() waits for that.
  std::mutex mutex_;
  PackagePtr inbox_;    // delivered, not yet taken
  PackagePtr pending_;  // told to send, not yet asked for
  std::atomic<bool> closed_{false};
  std::atomic<bool> kept_{false};    // pending_ is not null
  std::atomic<bool> filled_{false};  // inbox_ is not null
  std::atomic<std::uint64_t> missed_{0};
};

}  // namespace robotlink
