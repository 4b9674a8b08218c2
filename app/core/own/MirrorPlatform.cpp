// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/MirrorPlatform.h"

#include <google/protobuf/message.h>

#include <utility>

#include "robotlink/packages/ParsedMessage.h"

namespace app {

void assign(robotcontrol::WirePackage& to, std::size_t port, const google::protobuf::Message& package) {
  to.set_port(static_cast<std::uint32_t>(port));
  to.set_type(package.GetDescriptor()->full_name());
  package.SerializeToString(to.mutable_data());
}

robotlink::PackagePtr packageIn(const robotcontrol::WirePackage& wire) {
  return robotlink::parsedMessage(wire.type(), wire.data());
}

MirrorPlatform::MirrorPlatform(const robotcontrol::WireSetup& setup, const robotlink::Clock& clock)
    : Platform(setup.platform(), clock), taken_(static_cast<std::size_t>(setup.receivers_size())) {
  const auto blocking = [](const auto& port) {
    return port.blocking() ? robotlink::Blocking::kYes : robotlink::Blocking::kNo;
  };
  for (const auto& port : setup.senders()) {
    senders_.push_back(std::make_unique<robotlink::AnySender>(*this, port.package(), blocking(port)));
    turnOfSender_.push_back(port.turn());
    auto& turn = turns_[port.turn()];
    if (!turn && !port.turn().empty()) {
      turn = std::make_unique<StandInProcess>("turn of " + port.turn(), clock);
      turn->setFrame([this, name = port.turn()] { sendTurn(name); });
    }
    if (port.on_request()) onRequest_.push_back(senders_.back().get());
  }
  for (const auto& port : setup.receivers())
    receivers_.push_back(std::make_unique<robotlink::AnyReceiver>(*this, port.package(), blocking(port)));
}

void MirrorPlatform::setPackages(google::protobuf::RepeatedPtrField<robotcontrol::WirePackage> packages) {
  packages_ = std::move(packages);
}

void MirrorPlatform::wake() {
  Process::wake();
  if (wakeUp_) wakeUp_();
}

void MirrorPlatform::execute() {
  sendTurn({});
}

robotlink::Process* MirrorPlatform::turnOf(const std::string& process) {
  const auto found = turns_.find(process);
  return found == turns_.end() ? nullptr : found->second.get();
}

void MirrorPlatform::sendTurn(const std::string& turn) {
  google::protobuf::RepeatedPtrField<robotcontrol::WirePackage> later;
  for (auto& wire : packages_) {
    if (wire.port() >= senders_.size()) continue;
    if (turnOfSender_[wire.port()] != turn) {
      later.Add()->Swap(&wire);
    } else if (const auto package = packageIn(wire)) {
      senders_[wire.port()]->send(package);
    }
  }
  packages_.Swap(&later);
}

void MirrorPlatform::takeTo(google::protobuf::RepeatedPtrField<robotcontrol::WirePackage>& packages) {
  tryBeginFrame();
  for (std::size_t i = 0; i < receivers_.size(); ++i) {
    const robotlink::AnyReceiver& receiver = *receivers_[i];
    if (std::exchange(taken_[i], receiver.taken()) != receiver.taken())
      assign(*packages.Add(), i, *receiver.value());
  }
}

void MirrorPlatform::connectedTo(google::protobuf::RepeatedField<std::uint32_t>& senders) const {
  for (std::size_t i = 0; i < senders_.size(); ++i) {
    if (senders_[i]->connected()) senders.Add(static_cast<std::uint32_t>(i));
  }
}

void MirrorPlatform::fedTo(google::protobuf::RepeatedField<std::uint32_t>& receivers) const {
  for (std::size_t i = 0; i < receivers_.size(); ++i) {
    if (receivers_[i]->connected()) receivers.Add(static_cast<std::uint32_t>(i));
  }
}

}  // namespace app
