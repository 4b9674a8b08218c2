// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "widgets/solutions/SolutionModel.h"

namespace widgets {

/// The state of manual control: whether the user or the robot's own behavior commands it. It follows the task
/// that has a solution "obey" ("behavior" of four-legged robots, "driving" of those on wheels) in the robot's
/// SolutionTables, and knows which solution to request for taking control and for returning it (the one that
/// ran before). No I/O; not thread-safe.
class ManualControl {
 public:
  /// Name of the solution that obeys the user.
  static constexpr char kObey[] = "obey";
  /// kUnknown: no such task is known.
  /// kUnavailable: the task has no solution "obey", or it cannot be chosen.
  /// kFree: the robot's own behavior commands.
  /// kSwitching: a solution was requested and not yet confirmed.
  /// kTaken: the user commands.
  enum class State { kUnknown, kUnavailable, kFree, kSwitching, kTaken };

  /// Called with the tasks of each new table.
  void update(const std::vector<TaskEntry>& tasks);
  /// The solution to request for taking (or returning) control; empty if that is not possible or nothing
  /// would change.
  std::string begin(bool take);
  /// The request was refused.
  void refused(const QString& reason);
  /// The task whose solution is requested; empty while it is unknown.
  const std::string& task() const { return task_; }
  State state() const { return state_; }
  /// A sentence for the user: who commands, or why control cannot be taken.
  QString text() const;

 private:
  State state_ = State::kUnknown;
  std::string task_;
  /// The solution that runs.
  std::string active_;
  /// The solution that ran before "obey".
  std::string former_;
  /// The solution that was requested; empty: none.
  std::string requested_;
  /// The reason why the solution is unavailable or was refused.
  QString reason_;
};

}  // namespace widgets
