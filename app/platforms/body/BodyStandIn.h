// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "robotcontrol/Body.pb.h"
#include "robotlink/process/Platform.h"

namespace app {

/// Has the packages of a remote body, for a program that is not the one with the platform. It is never
/// executed.
class BodyStandIn final : public robotlink::Platform {
 public:
  BodyStandIn(const robotcontrol::BodyOffer& offer, const robotlink::Clock& clock);

  void actuate() override {}
  void engageStop(bool) override {}

 protected:
  void execute() override {}

 private:
  std::vector<std::unique_ptr<robotlink::AnySender>> senders_;
  std::vector<std::unique_ptr<robotlink::AnyReceiver>> receivers_;
};

}  // namespace app
