// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/Receiver.h"

#include <google/protobuf/message.h>

namespace robotlink {

AnyReceiver::AnyReceiver(EndOwner& process, std::string package, Blocking blocking)
    : process_(process), package_(std::move(package)), blocking_(blocking) {
  process.add(*this);
}

AnyReceiver::~AnyReceiver() {
  close();
}

bool AnyReceiver::connected() const {
  const std::lock_guard lock(mutex_);
  return link_ && !link_->closed();
}

std::string AnyReceiver::peer() const {
  const std::lock_guard lock(mutex_);
  return peer_;
}

std::string AnyReceiver::typeName() const {
  const auto* type = type_.load(std::memory_order_acquire);
  return type != nullptr ? type->full_name() : std::string();
}

std::uint64_t AnyReceiver::generation() const {
  const std::lock_guard lock(mutex_);
  return link_ ? link_->generation() : 0;
}

void AnyReceiver::connect(std::shared_ptr<Link> link, std::string peer) {
  {
    const std::lock_guard lock(mutex_);
    link_.swap(link);
    if (link) missedBefore_ += link->missed();
    peer_ = std::move(peer);
  }
  if (link) link->close();
  process_.wake();  // The new link may already hold a package.
}

void AnyReceiver::take() {
  const std::lock_guard lock(mutex_);
  if (!link_) return;
  while (PackagePtr package = link_->take()) {
    value_ = std::move(package);
    taken_.fetch_add(1, std::memory_order_relaxed);
    if (arrived_) unused_.fetch_add(1, std::memory_order_relaxed);
    arrived_ = true;
  }
  if (value_ && type_.load(std::memory_order_relaxed) == nullptr) {
    type_.store(value_->GetDescriptor(), std::memory_order_release);
  }
}

void AnyReceiver::beginFrame() {
  isNew_ = arrived_;
  arrived_ = false;
}

void AnyReceiver::close() {
  const std::lock_guard lock(mutex_);
  if (link_) link_->close();
}

std::uint64_t AnyReceiver::missed() const {
  const std::lock_guard lock(mutex_);
  return unused_.load(std::memory_order_relaxed) + missedBefore_ + (link_ ? link_->missed() : 0);
}

std::string AnyReceiver::waitsFor() const {
  const std::lock_guard lock(mutex_);
  const std::string what = "package " + package_;
  if (!link_) return what + ", which no process sends";
  const char* state = taken() > 0 ? ", which has stopped" : ", which does not run";
  return what + " of " + peer_ + (link_->closed() ? state : "");
}

}  // namespace robotlink
