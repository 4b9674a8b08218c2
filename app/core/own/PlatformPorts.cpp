// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/PlatformPorts.h"

#include <google/protobuf/message.h>

#include <algorithm>

#include "app/core/own/MirrorPlatform.h"
#include "robotlink/packages/PackageTypes.h"

namespace app {
namespace {

/// Receivers rely on the type, but a program that misbehaves may send anything.
bool isOfItsType(const google::protobuf::Message& package, const robotlink::AnySender& sender) {
  const auto* expected = robotlink::typeOfPackage(sender.package());
  return expected == nullptr || package.GetDescriptor() == expected;
}

}  // namespace

/// The link from a sender of the platform: delivers at once.
class PlatformPorts::Collector final : public robotlink::Link {
 public:
  Collector(PlatformPorts& ports, std::size_t port) : ports_(ports), port_(port) {}

  void offer(robotlink::PackagePtr package) override {
    if (closed_) return;
    Packages& all = ports_.collected_;
    if (ports_.behind_) {
      const auto old = std::ranges::find_if(all, [this](const auto& wire) { return wire.port() == port_; });
      if (old != all.end()) all.erase(old);
    }
    robotcontrol::WirePackage& wire = *all.Add();
    if (ports_.connected_.contains(static_cast<std::uint32_t>(port_))) {
      assign(wire, port_, *package);
    } else {
      wire.set_port(static_cast<std::uint32_t>(port_));
      wire.set_type(package->GetDescriptor()->full_name());
    }
  }
  bool delivered() const override { return true; }
  robotlink::PackagePtr take() override { return nullptr; }
  void close() override { closed_ = true; }
  bool closed() const override { return closed_; }
  std::uint64_t missed() const override { return 0; }

 private:
  PlatformPorts& ports_;
  const std::size_t port_;
  bool closed_ = false;
};

PlatformPorts::PlatformPorts(robotlink::Platform& platform, robotlink::EndOwner& owner)
    : platform_(platform), collectors_(platform.senders().size()) {
  for (const robotlink::AnyReceiver* receiver : platform.receivers()) {
    senders_.push_back(
        std::make_unique<robotlink::AnySender>(owner, receiver->package(), robotlink::Blocking::kNo));
  }
}

PlatformPorts::~PlatformPorts() {
  close();
}

bool PlatformPorts::isOnRequest(std::size_t port) const {
  const auto onRequest = platform_.onRequest();
  return std::ranges::find(onRequest, platform_.senders()[port]) != onRequest.end();
}

void PlatformPorts::describeTo(robotcontrol::WireSetup& setup,
                               const std::map<std::string, std::string>& turns) const {
  setup.set_platform(platform_.name());
  for (std::size_t i = 0; i < platform_.senders().size(); ++i) {
    auto& port = *setup.add_senders();
    port.set_package(platform_.senders()[i]->package());
    port.set_blocking(platform_.senders()[i]->blocking());
    port.set_on_request(isOnRequest(i));
    if (const auto turn = turns.find(port.package()); turn != turns.end()) port.set_turn(turn->second);
  }
  for (const robotlink::AnyReceiver* receiver : platform_.receivers()) {
    auto& port = *setup.add_receivers();
    port.set_package(receiver->package());
    port.set_blocking(receiver->blocking());
  }
}

void PlatformPorts::connect(const Indices& fed, const Indices& connected) {
  for (const std::uint32_t port : fed) {
    if (port < senders_.size()) connectUnchecked(*senders_[port], *platform_.receivers()[port]);
  }
  setConnected(connected);
}

void PlatformPorts::setConnected(const Indices& connected) {
  std::set<std::uint32_t> wantedPorts(connected.begin(), connected.end());
  if (linked_ && wantedPorts == connected_) return;
  linked_ = true;
  connected_ = std::move(wantedPorts);
  for (std::size_t i = 0; i < collectors_.size(); ++i) {
    const bool wanted = !isOnRequest(i) || connected_.contains(static_cast<std::uint32_t>(i));
    if (wanted && !collectors_[i]) {
      collectors_[i] = std::make_shared<Collector>(*this, i);
      platform_.senders()[i]->connect(collectors_[i]);
    } else if (!wanted && collectors_[i]) {
      collectors_[i]->close();
      collectors_[i].reset();
    }
  }
}

void PlatformPorts::setBehind(bool behind) {
  behind_ = behind;
}

void PlatformPorts::takeTo(Packages& packages) {
  packages.Swap(&collected_);
  collected_.Clear();
}

void PlatformPorts::send(const Packages& packages) {
  for (const auto& wire : packages) {
    if (wire.port() >= senders_.size()) continue;
    robotlink::AnySender& sender = *senders_[wire.port()];
    if (const auto package = packageIn(wire); package && isOfItsType(*package, sender)) sender.send(package);
  }
}

void PlatformPorts::close() {
  for (auto& collector : collectors_) {
    if (collector) collector->close();
    collector.reset();
  }
  collected_.Clear();
}

}  // namespace app
