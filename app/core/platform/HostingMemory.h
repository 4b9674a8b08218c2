// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <mutex>
#include <set>
#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/session/Settings.h"

namespace app {

/// Where the user wants the programs of the robots of one kind of platform to run. A plain value.
struct HostingChoices {
  /// In processes of their own, unless they are among `otherwise`, by their names.
  bool ownProcesses = false;
  std::set<std::string> otherwise = {};
  /// Each process of the layouts in a thread, rather than in lockstep.
  bool threads = false;
  bool operator==(const HostingChoices&) const = default;

  bool isOwn(const std::string& robot) const { return ownProcesses != otherwise.contains(robot); }
};

/// These choices, kept in a file from one run of the workbench to the next. Any thread.
class HostingMemory {
 public:
  explicit HostingMemory(std::filesystem::path file);

  /// Keyed by the name of the PlatformAdapter; the default if nothing was chosen yet.
  HostingChoices choices(const std::string& adapter) const;
  void choose(const std::string& adapter, const HostingChoices& choices);
  /// Writes the file if something was chosen since the last time. Fails once for each change.
  robotlink::Result<void> save();

 private:
  /// Protects the other members.
  mutable std::mutex mutex_;
  robotlink::Settings settings_;
  bool hasChanged_ = false;
};

}  // namespace app
