// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/ProgramNet.h"

#include "robotlink/dds/Fingerprint.h"
#include "robotlink/dds/ReceivingEnd.h"
#include "robotlink/dds/SendingEnd.h"
#include "robotlink/process/Sender.h"

namespace robotlink::dds {

ProgramNet::ProgramNet(std::shared_ptr<Node> node, Identity identity, const Clock& clock, Behavior behavior)
    : node_(std::move(node)), identity_(std::move(identity)), clock_(clock), behavior_(std::move(behavior)) {
  if (!behavior_.fingerprint) behavior_.fingerprint = &fingerprintOf;
  if (!behavior_.report) behavior_.report = [](const std::string&) {};
}

ProgramNet::~ProgramNet() = default;

EndSetup ProgramNet::setupOf(const std::string& package, const std::string& from,
                             const std::string& process) const {
  return {.node = node_,
          .package = package,
          .topic = "robotcontrol/" + identity_.robot + "/" + from + "/" + package,
          .program = identity_.program,
          .process = process,
          .clock = &clock_,
          .fingerprint = behavior_.fingerprint,
          .report = behavior_.report};
}

Result<void> ProgramNet::link(AnySender& sender, const std::string& from) {
  const std::lock_guard lock(mutex_);
  std::weak_ptr<SendingEnd>& known = senders_[&sender];
  if (const auto present = known.lock(); present && !present->ended()) return {};
  auto end = SendingEnd::open(setupOf(sender.package(), from, from), sender.process(), sender.blocking());
  if (!end) return tl::unexpected(end.error());
  known = *end;
  sender.connect(std::move(*end));
  return {};
}

Result<void> ProgramNet::link(AnyReceiver& receiver, const std::string& from) {
  const std::lock_guard lock(mutex_);
  auto end =
      ReceivingEnd::open(setupOf(receiver.package(), from, receiver.process().name()), receiver.process());
  if (!end) return tl::unexpected(end.error());
  receivers_[&receiver] = *end;
  receiver.connect(std::move(*end), from);
  return {};
}

std::shared_ptr<SendingEnd> ProgramNet::sendingEnd(const AnySender& sender) const {
  const std::lock_guard lock(mutex_);
  const auto found = senders_.find(&sender);
  return found == senders_.end() ? nullptr : found->second.lock();
}

std::shared_ptr<ReceivingEnd> ProgramNet::receivingEnd(const AnyReceiver& receiver) const {
  const std::lock_guard lock(mutex_);
  const auto found = receivers_.find(&receiver);
  return found == receivers_.end() ? nullptr : found->second.lock();
}

}  // namespace robotlink::dds
