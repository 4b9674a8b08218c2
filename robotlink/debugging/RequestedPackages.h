// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "robotlink/debugging/ModeCounter.h"
#include "robotlink/process/Process.h"

namespace robotlink {

class DebugContext;

/// The packages that a platform makes only while somebody receives them (Platform::onRequest()): received and
/// told while their keys are on, and else not linked at all. Used by the debug process; only for this folder.
class RequestedPackages {
 public:
  RequestedPackages(Process& process, DebugContext& debug) : process_(process), debug_(debug) {}

  /// The sender must outlive this. Before the process runs.
  void add(AnySender& sender);
  bool has(const std::string& package) const { return packages_.contains(package); }
  /// False if there is none of that name.
  bool show(const std::string& package, const robotcontrol::KeyMode& mode);
  /// Tells what came for this frame, with the times that images have. Whether a mode has run out.
  bool tellNews();
  void fillKeys(robotcontrol::KeyTable& to) const;

 private:
  struct Package {
    AnySender* sender = nullptr;
    std::unique_ptr<AnyReceiver> receiver;
    ModeCounter mode;

    bool wanted() const { return mode.mode().kind() != robotcontrol::KeyMode::OFF; }
    void link() const;
  };
  void tell(const std::string& name, const google::protobuf::Message& package);

  Process& process_;
  DebugContext& debug_;
  std::map<std::string, Package> packages_;
};

}  // namespace robotlink
