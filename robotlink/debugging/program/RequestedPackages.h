// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "robotlink/debugging/ModeCounter.h"
#include "robotlink/process/Process.h"

namespace robotlink {

class DebugContext;

/// The packages that a platform produces only while they are received (Platform::onRequest()): received and
/// published while their keys are on, otherwise not linked at all. Used by the debug process; internal to
/// this folder.
class RequestedPackages {
 public:
  RequestedPackages(Process& process, DebugContext& debug) : process_(process), debug_(debug) {}

  /// The sender must outlive this object. Before the process runs.
  void add(AnySender& sender);
  bool has(const std::string& package) const { return packages_.contains(package); }
  /// Sets when a package is published; returns false if there is none of that name.
  bool show(const std::string& package, const robotcontrol::KeyMode& mode);
  /// Returns the last package of its sender, also while no one received it; null if there is none.
  PackagePtr newest(const std::string& package) const;
  /// Publishes the packages that arrived for this frame, images with their own timestamps. Returns whether a
  /// mode has run out.
  bool publishNews();
  /// Adds the keys of the packages to a table.
  void fillKeys(robotcontrol::KeyTable& to) const;

 private:
  struct Package {
    AnySender* sender = nullptr;
    std::unique_ptr<AnyReceiver> receiver;
    ModeCounter mode;

    // True while its key is on.
    bool wanted() const { return mode.mode().kind() != robotcontrol::KeyMode::OFF; }
    /// Connects or disconnects the receiver according to the mode.
    void link() const;
  };
  void publish(const std::string& name, const PackagePtr& package);

  Process& process_;
  DebugContext& debug_;
  std::map<std::string, Package> packages_;
};

}  // namespace robotlink
