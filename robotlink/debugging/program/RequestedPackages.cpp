// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/RequestedPackages.h"

#include "foxglove/Image.pb.h"
#include "robotlink/debugging/DebugContext.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/TaskTables.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/process/Process.h"

namespace robotlink {

void RequestedPackages::Package::link() const {
  if (wanted() == receiver->connected()) return;
  if (wanted()) {
    connectUnchecked(*sender, *receiver);
  } else {
    receiver->connect(nullptr, {});
  }
}

void RequestedPackages::add(AnySender& sender) {
  Package& package = packages_[sender.package()];
  package.sender = &sender;
  package.receiver = std::make_unique<AnyReceiver>(process_, sender.package(), Blocking::kNo);
}

bool RequestedPackages::show(const std::string& package, const robotcontrol::KeyMode& mode) {
  const auto found = packages_.find(package);
  if (found == packages_.end()) return false;
  found->second.mode.set(mode);
  found->second.link();
  return true;
}

PackagePtr RequestedPackages::newest(const std::string& package) const {
  const auto found = packages_.find(package);
  return found == packages_.end() ? nullptr : found->second.sender->newest();
}

bool RequestedPackages::publishNews() {
  bool expired = false;
  for (auto& [name, package] : packages_) {
    if (!package.wanted() || !package.receiver->isNew() || !package.mode.due(process_.frameTime())) continue;
    publish(name, package.receiver->value());
    expired |= !package.wanted();
    package.link();
  }
  return expired;
}

void RequestedPackages::publish(const std::string& name, const PackagePtr& package) {
  SharedDebugMessage& message = debug_.package(name, package);
  // An image belongs to the time at which it was taken, not to the frame in which it arrived here.
  if (const auto* image = message.as<foxglove::RawImage>()) message.time = instant(image->timestamp());
}

void RequestedPackages::fillKeys(robotcontrol::KeyTable& to) const {
  for (const auto& [name, package] : packages_) fillPackageKey(name, package.mode.mode(), *to.add_keys());
}

}  // namespace robotlink
