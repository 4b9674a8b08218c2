// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "app/platforms/replay/ReplayPlan.h"
#include "robotlink/session/StreamMessage.h"

namespace app {

/// Decides on which path the messages of a robot's log are published while a program runs on the log: on
/// their own path, unless the program publishes the same; then the program's go there and the logged ones to
/// "<robot>/logged/<path>". The rule is described in robotlink/session/STREAMS.md. One thread.
class LoggedPaths {
 public:
  /// The paths of a log of which nothing is recomputed.
  LoggedPaths() = default;
  /// For the program of a plan, which is only used during the call.
  explicit LoggedPaths(const ReplayPlan& plan);

  /// Whether the program publishes what a logged stream contains. `path` is the one below the robot's name.
  /// `value` matters only for texts, which the program publishes for the tasks and processes that run.
  bool isRecomputed(const std::string& path, const google::protobuf::Message& value) const;
  /// Whether a process of the layout runs again, so that its frames are counted from zero.
  bool runs(const std::string& process) const { return processes_.contains(process); }

 private:
  /// The answer for all messages of a path; isRecomputed() caches it.
  bool decide(const std::string& path) const;
  /// Whether a debug key belongs to a task that runs. Plots may have a curve's name behind that of their key.
  bool isRecomputedKey(std::string key) const;
  /// Whether a text comes from a task or process that runs; `source` is "<process>/<task>", or begins with a
  /// process.
  bool isRecomputedText(const std::string& source) const;

  /// Tasks and processes that run.
  std::set<std::string> tasks_;
  std::set<std::string> processes_;
  /// Names of packages.
  std::set<std::string> recomputed_;
  /// Debug keys of all solutions of the tasks that run.
  std::set<std::string> keys_;
  /// Whether a task that runs can use a color table.
  bool looksAtColors_ = false;
  /// Whether a task that runs plays key-frame motions.
  bool playsMotions_ = false;
  /// The results of decide().
  mutable std::map<std::string, bool> known_;
};

}  // namespace app
