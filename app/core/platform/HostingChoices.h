// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace app {

/// The user's choice of where the programs of one kind of platform run: in this process or in their own. A
/// plain value.
struct HostingChoices {
  /// In processes of their own, unless they are among `otherwise`, by their names.
  bool ownProcesses = false;
  std::set<std::string> otherwise = {};
  /// Each process of the layouts in a thread, rather than in lockstep.
  bool threads = false;
  bool operator==(const HostingChoices&) const = default;

  bool isOwn(const std::string& robot) const { return ownProcesses != otherwise.contains(robot); }
  /// Whether the program of a robot runs in a process of its own; without a name, those of all robots.
  void choose(const std::string& robot, bool own);
};

}  // namespace app
