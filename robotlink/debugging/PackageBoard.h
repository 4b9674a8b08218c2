// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/debugging/ModeCounter.h"
#include "robotlink/process/Process.h"

namespace robotlink {

class DebugContext;

/// The packages that the tasks of one process read and yield: what came from other processes, what the tasks
/// sent, and which of them somebody wants to see. Used by the process's thread; only for this folder.
class PackageBoard {
 public:
  struct Entry {
    std::string name;
    PackagePtr value;            // null before the first
    std::uint64_t arrivals = 0;  // how many packages there were
    std::unique_ptr<AnyReceiver> receiver;
    std::unique_ptr<AnySender> sender;
    bool shown = false;  // this process shows it on request
    ModeCounter mode;
    bool recorded = false;  // told whatever the mode
  };

  PackageBoard(Process& process, DebugContext& debug) : process_(process), debug_(debug) {}

  /// A new one if there is none; its address stays the same.
  Entry& entry(const std::string& package);
  void addReceiver(const std::string& package, Blocking blocking);
  void addSender(const std::string& package);

  /// Puts what the receivers took for this frame on the board.
  void beginFrame();
  void send(Entry& entry, const PackagePtr& package);

  /// False if this process does not show the package.
  bool show(const std::string& package, const robotcontrol::KeyMode& mode);
  /// From now on these of the shown packages are told whatever their modes, and no others.
  void record(const std::set<std::string>& packages);
  /// What this process shows on request, by name.
  std::vector<const Entry*> shown() const;
  /// Whether a mode of a package has run out since the last call.
  bool takeModeChange();

 private:
  void put(Entry& entry, PackagePtr package);
  bool askedFor(Entry& entry);

  Process& process_;
  DebugContext& debug_;
  std::map<std::string, Entry> entries_;
  bool modeChanged_ = false;
};

}  // namespace robotlink
