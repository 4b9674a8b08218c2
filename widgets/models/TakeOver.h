// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "widgets/models/SolutionModel.h"

namespace widgets {

/// Whether a person or the robot's own behaviour commands it: follows the task "behavior" in the robot's
/// tables and knows which solution to request for taking over ("obey") and for giving back (the one that ran
/// before). Pure; one thread.
class TakeOver {
 public:
  static constexpr char kTask[] = "behavior";
  static constexpr char kObey[] = "obey";
  enum class State { kUnknown, kUnavailable, kFree, kSwitching, kTaken };

  /// What the robot tells now.
  void update(const std::vector<TaskEntry>& tasks);
  /// The solution to request for the change; empty if it cannot be had.
  std::string begin(bool take);
  void refused(const QString& reason);
  State state() const { return state_; }
  /// One sentence: who commands, or why it cannot be taken over.
  QString text() const;

 private:
  State state_ = State::kUnknown;
  std::string active_;
  std::string former_;
  std::string wished_;
  QString reason_;
};

}  // namespace widgets
