// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"

namespace robotlink {

struct SharedDebugQueue;

/// The merged tables of all processes: one of keys, one of solutions. A key is in use if any process uses it;
/// of several modes one that is on wins. Used by the debug process; internal to this folder.
class JoinedTables {
 public:
  /// Takes over the tables in a process's queue, if there are any.
  void notice(const SharedDebugQueue& queue);
  /// Sets a process's keys without marking the table as changed.
  void setKeys(const std::string& process, robotcontrol::KeyTable keys) { keys_[process] = std::move(keys); }
  void setSolutions(const std::string& process, robotcontrol::SolutionTable solutions) {
    solutions_[process] = std::move(solutions);
  }
  /// Marks the table of keys as changed.
  void publishKeys() { keysChanged_ = true; }
  /// Returns whether the table has changed since the last call.
  bool takeKeysChanged() { return std::exchange(keysChanged_, false); }
  bool takeSolutionsChanged() { return std::exchange(solutionsChanged_, false); }
  /// Sorted by name.
  void fillKeys(robotcontrol::KeyTable& to) const;
  /// Processes and their tasks in the given order.
  void fillSolutions(const std::vector<std::string>& processes, robotcontrol::SolutionTable& to) const;

 private:
  /// Keyed by process, as is solutions_.
  std::map<std::string, robotcontrol::KeyTable> keys_;
  std::map<std::string, robotcontrol::SolutionTable> solutions_;  // by process
  bool keysChanged_ = false;
  bool solutionsChanged_ = false;
};

}  // namespace robotlink
