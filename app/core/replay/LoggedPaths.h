// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "app/core/replay/ReplayPlan.h"
#include "robotlink/session/StreamMessage.h"

namespace app {

/// Where what a robot's log holds is told while a program runs on it: on its own path, unless the program
/// tells the same, which then goes there while the logged goes to "<robot>/logged/<path>". The rule stands in
/// robotlink/session/STREAMS.md.
class LoggedPaths {
 public:
  LoggedPaths() = default;
  explicit LoggedPaths(const ReplayPlan& plan);

  /// `path`: below the robot. Only texts are looked into.
  bool isRecomputed(const std::string& path, const google::protobuf::Message& value) const;
  /// The process runs again: its frames are counted anew.
  bool runs(const std::string& process) const { return processes_.contains(process); }

 private:
  bool decide(const std::string& path) const;
  bool isRecomputedKey(std::string key) const;
  bool isRecomputedText(const std::string& source) const;

  std::set<std::string> tasks_;  // that run
  std::set<std::string> processes_;
  std::set<std::string> recomputed_;  // packages
  std::set<std::string> keys_;        // of solutions of these tasks
  bool looksAtColors_ = false;        // a task that runs uses a color table
  mutable std::map<std::string, bool> known_;
};

}  // namespace app
