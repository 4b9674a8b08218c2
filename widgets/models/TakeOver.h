// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "widgets/models/SolutionModel.h"

namespace widgets {

/// Whether a person or the robot's own behaviour commands it: follows the task that has a solution "obey" in
/// the robot's tables ("behavior" of four-legged robots, "driving" of those on wheels) and knows which
/// solution to request for taking over and for giving back (the one that ran before). Pure; one thread.
class TakeOver {
 public:
  static constexpr char kObey[] = "obey";
  enum class State { kUnknown, kUnavailable, kFree, kSwitching, kTaken };

  /// What the robot tells now.
  void update(const std::vector<TaskEntry>& tasks);
  /// The solution to request for the change; empty if it cannot be had.
  std::string begin(bool take);
  void refused(const QString& reason);
  /// Whose solution is to be requested; empty while it is not known.
  const std::string& task() const { return task_; }
  State state() const { return state_; }
  /// One sentence: who commands, or why it cannot be taken over.
  QString text() const;

 private:
  State state_ = State::kUnknown;
  std::string task_;
  std::string active_;
  std::string former_;
  std::string wished_;
  QString reason_;
};

}  // namespace widgets
