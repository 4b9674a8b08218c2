// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/Sender.h"

#include <google/protobuf/message.h>

#include <algorithm>

#include "robotlink/process/InProcessLink.h"

namespace robotlink {

AnySender::AnySender(EndOwner& process, std::string package, Blocking blocking)
    : process_(process), package_(std::move(package)), blocking_(blocking) {
  process.add(*this);
}

AnySender::~AnySender() {
  close();
}

bool AnySender::connected() const {
  const std::lock_guard lock(mutex_);
  return std::any_of(links_.begin(), links_.end(), [](const auto& link) { return !link->closed(); });
}

std::string AnySender::typeName() const {
  const auto* type = type_.load(std::memory_order_acquire);
  return type != nullptr ? type->full_name() : std::string();
}

void AnySender::connect(std::shared_ptr<Link> link) {
  const std::lock_guard lock(mutex_);
  std::erase_if(links_, [](const auto& old) { return old->ended(); });
  links_.push_back(std::move(link));
}

void AnySender::addTap(Tap tap) {
  const std::lock_guard lock(mutex_);
  taps_.push_back(std::move(tap));
}

void AnySender::send(const PackagePtr& package) {
  sent_.fetch_add(1, std::memory_order_relaxed);
  if (type_.load(std::memory_order_relaxed) == nullptr) {
    type_.store(package->GetDescriptor(), std::memory_order_release);
  }
  const std::lock_guard lock(mutex_);
  newest_ = package;
  for (const Tap& tap : taps_) tap(package);
  for (const auto& link : links_) link->offer(package);
}

PackagePtr AnySender::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

bool AnySender::delivered() const {
  const std::lock_guard lock(mutex_);
  return std::all_of(links_.begin(), links_.end(), [](const auto& link) { return link->delivered(); });
}

void AnySender::close() {
  const std::lock_guard lock(mutex_);
  for (const auto& link : links_) link->close();
}

void connectUnchecked(AnySender& sender, AnyReceiver& receiver) {
  auto link = std::make_shared<InProcessLink>(sender.process(), receiver.process());
  receiver.connect(link, sender.process().name());
  sender.connect(std::move(link));
}

}  // namespace robotlink
