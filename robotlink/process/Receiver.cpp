// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/Receiver.h"

#include "robotlink/process/Process.h"

namespace robotlink {

AnyReceiver::AnyReceiver(Process& process, std::string package, Blocking blocking)
    : process_(process), package_(std::move(package)), blocking_(blocking) {
  process.add(*this);
}

void AnyReceiver::connect(std::shared_ptr<Link> link, std::string peer) {
  link_ = std::move(link);
  peer_ = std::move(peer);
}

void AnyReceiver::take() {
  if (!link_) return;
  while (PackagePtr package = link_->take()) {
    value_ = std::move(package);
    taken_.fetch_add(1, std::memory_order_relaxed);
    if (arrived_) unused_.fetch_add(1, std::memory_order_relaxed);
    arrived_ = true;
  }
}

void AnyReceiver::beginFrame() {
  isNew_ = arrived_;
  arrived_ = false;
}

void AnyReceiver::close() {
  if (link_) link_->close();
}

std::uint64_t AnyReceiver::missed() const {
  return unused_.load(std::memory_order_relaxed) + (link_ ? link_->missed() : 0);
}

}  // namespace robotlink
