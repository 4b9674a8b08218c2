// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"

namespace robotlink {

/// The tables of all processes, joined: one of keys, one of solutions. A key of several processes is in use
/// if one of them uses it, and has the mode that is still on in one of them. Used by the debug process; only
/// for this folder.
class JoinedTables {
 public:
  /// Looks for the tables of a process in its queue.
  void notice(const robotcontrol::DebugQueue& queue);
  /// The keys of one process, known otherwise. Told with the next change.
  void setKeys(const std::string& process, robotcontrol::KeyTable keys) { keys_[process] = std::move(keys); }
  void setSolutions(const std::string& process, robotcontrol::SolutionTable solutions) {
    solutions_[process] = std::move(solutions);
  }
  void tellKeys() { keysChanged_ = true; }
  bool takeKeysChanged() { return std::exchange(keysChanged_, false); }
  bool takeSolutionsChanged() { return std::exchange(solutionsChanged_, false); }
  /// By name.
  void fillKeys(robotcontrol::KeyTable& to) const;
  /// Processes and their tasks in the order given.
  void fillSolutions(const std::vector<std::string>& processes, robotcontrol::SolutionTable& to) const;

 private:
  std::map<std::string, robotcontrol::KeyTable> keys_;            // by process
  std::map<std::string, robotcontrol::SolutionTable> solutions_;  // by process
  bool keysChanged_ = false;
  bool solutionsChanged_ = false;
};

}  // namespace robotlink
