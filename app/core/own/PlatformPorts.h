// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotcontrol/ProgramWire.pb.h"
#include "robotlink/process/Platform.h"

namespace app {

/// The links of a platform with a program in another process: collects what the platform sends, and sends
/// what goes to it. The platform must outlive it. One thread at a time.
class PlatformPorts {
 public:
  /// Packages by the index of their port, as they go over the wire.
  using Packages = google::protobuf::RepeatedPtrField<robotcontrol::WirePackage>;
  using Indices = google::protobuf::RepeatedField<std::uint32_t>;

  /// Changes nothing at the platform. `owner` has the senders to it.
  PlatformPorts(robotlink::Platform& platform, robotlink::EndOwner& owner);
  ~PlatformPorts();

  /// Describes the platform's ports; `turns` are OwnProgramOptions::turns.
  void describeTo(robotcontrol::WireSetup& setup, const std::map<std::string, std::string>& turns) const;
  /// Makes the links: the receivers in `fed` get packages.
  void connect(const Indices& fed, const Indices& connected);
  /// Sets which senders have receivers in the program. Those that produce only on request are connected
  /// only then; of the others, only the types go over the wire.
  void setConnected(const Indices& connected);
  /// Whether the program falls behind: only the newest package of each sender is kept.
  void setBehind(bool behind);
  /// Moves what was collected since the last call.
  void takeTo(Packages& packages);
  /// Sends packages to the platform.
  void send(const Packages& packages);
  /// Closes the links from the platform.
  void close();

 private:
  class Collector;
  bool isOnRequest(std::size_t port) const;

  robotlink::Platform& platform_;
  std::vector<std::shared_ptr<Collector>> collectors_;  // of the senders; null: not linked
  std::vector<std::unique_ptr<robotlink::AnySender>> senders_;
  std::set<std::uint32_t> connected_;
  bool linked_ = false;  // setConnected() was called
  bool behind_ = false;
  Packages collected_;
};

}  // namespace app
