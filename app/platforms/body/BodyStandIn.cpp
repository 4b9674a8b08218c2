// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/BodyStandIn.h"

#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/packages/Packages.h"

namespace app {

BodyStandIn::BodyStandIn(const robotcontrol::BodyOffer& offer, const robotlink::Clock& clock)
    : Platform("platform", clock) {
  const auto types = robotlink::allPackageTypes();
  const auto addSender = [this](const std::string& package) {
    senders_.push_back(std::make_unique<robotlink::AnySender>(*this, package, robotlink::Blocking::kNo));
  };
  // The state of the link is the platform's own.
  addSender(robotlink::kLinkStatus.name);
  for (const std::string& package : offer.sensors()) {
    if (types.contains(package) && package != robotlink::kLinkStatus.name) addSender(package);
  }
  for (const std::string& package : offer.commands()) {
    if (types.contains(package))
      receivers_.push_back(
          std::make_unique<robotlink::AnyReceiver>(*this, package, robotlink::Blocking::kNo));
  }
}

}  // namespace app
