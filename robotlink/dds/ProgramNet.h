// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "robotlink/dds/EndSetup.h"
#include "robotlink/process/ProgramLinks.h"

namespace robotlink::dds {

class ReceivingEnd;
class SendingEnd;

/// The links of one program of a robot to the robot's other programs, over DDS (DDS.md). Any thread; the
/// links keep what they need of it.
class ProgramNet final : public ProgramLinks {
 public:
  /// The robot and the program that take part, as a value.
  struct Identity {
    /// The robot: "p3at1". Robots on one network have different names.
    std::string robot;
    /// The program as the layout names it.
    std::string program;
  };
  /// The behavior of the program in the network; the functions may be empty.
  struct Behavior {
    /// Computes the fingerprints of types; by default fingerprintOf().
    std::function<std::uint64_t(const google::protobuf::Descriptor& type)> fingerprint = {};
    /// Gets sentences for the user, in threads of DDS; must not block.
    std::function<void(const std::string& text)> report = {};
  };
  /// The clock must outlive all links.
  ProgramNet(std::shared_ptr<Node> node, Identity identity, const Clock& clock, Behavior behavior);
  ~ProgramNet() override;

  Result<void> link(AnySender& sender, const std::string& from) override;
  Result<void> link(AnyReceiver& receiver, const std::string& from) override;

  // For tests: the halves that were made last for an end; null if there is none any longer.
  std::shared_ptr<SendingEnd> sendingEnd(const AnySender& sender) const;
  std::shared_ptr<ReceivingEnd> receivingEnd(const AnyReceiver& receiver) const;

 private:
  EndSetup setupOf(const std::string& package, const std::string& from, const std::string& process) const;

  const std::shared_ptr<Node> node_;
  const Identity identity_;
  const Clock& clock_;
  Behavior behavior_;
  mutable std::mutex mutex_;  // protects what follows
  std::map<const AnySender*, std::weak_ptr<SendingEnd>> senders_;
  std::map<const AnyReceiver*, std::weak_ptr<ReceivingEnd>> receivers_;
};

}  // namespace robotlink::dds
