// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/ManualControl.h"

#include <QCoreApplication>
#include <algorithm>

namespace widgets {
namespace {

struct ManualText {
  Q_DECLARE_TR_FUNCTIONS(ManualControl)
};

bool obeys(const TaskEntry& task) {
  return std::any_of(task.solutions.begin(), task.solutions.end(),
                     [](const auto& solution) { return solution.name == ManualControl::kObey; });
}

/// The first task with a solution "obey"; if there is none, the first task that should have one. Null: none.
const TaskEntry* findTask(const std::vector<TaskEntry>& tasks) {
  auto found = std::find_if(tasks.begin(), tasks.end(), obeys);
  if (found == tasks.end()) {
    found = std::find_if(tasks.begin(), tasks.end(),
                         [](const auto& task) { return task.name == "behavior" || task.name == "driving"; });
  }
  return found == tasks.end() ? nullptr : &*found;
}

}  // namespace

void ManualControl::update(const std::vector<TaskEntry>& tasks) {
  const TaskEntry* task = findTask(tasks);
  if (task == nullptr) {
    *this = {};
    return;
  }
  if (task->name != task_) *this = {};
  task_ = task->name;
  active_ = task->active;
  if (active_ != kObey) former_ = active_;
  if (former_.empty()) former_ = task->standard;
  const auto obey = std::find_if(task->solutions.begin(), task->solutions.end(),
                                 [](const auto& solution) { return solution.name == kObey; });
  if (requested_ == active_) requested_.clear();
  if (active_ == kObey && requested_.empty()) {
    state_ = State::kTaken;
  } else if (!requested_.empty()) {
    state_ = State::kSwitching;
  } else if (obey == task->solutions.end() || !obey->unavailable.isEmpty()) {
    state_ = State::kUnavailable;
    reason_ = obey == task->solutions.end()
                  ? ManualText::tr("its %1 has no solution “obey”").arg(QString::fromStdString(task_))
                  : obey->unavailable;
  } else {
    state_ = State::kFree;
  }
}

std::string ManualControl::begin(bool take) {
  if (state_ == State::kUnknown || (take && state_ == State::kUnavailable)) return {};
  const std::string wanted = take ? kObey : former_;
  if (wanted.empty() || wanted == active_) return {};
  requested_ = wanted;
  reason_.clear();
  state_ = State::kSwitching;
  return wanted;
}

void ManualControl::refused(const QString& reason) {
  requested_.clear();
  reason_ = reason;
  state_ = active_ == kObey ? State::kTaken : State::kFree;
}

QString ManualControl::text() const {
  switch (state_) {
    case State::kUnknown:
      return ManualText::tr("The robot has not reported its behavior yet.");
    case State::kUnavailable:
      return ManualText::tr("Cannot be taken over: %1").arg(reason_);
    case State::kSwitching:
      return ManualText::tr("Switching to %1…").arg(QString::fromStdString(requested_));
    case State::kTaken:
      return ManualText::tr("You steer the robot.");
    case State::kFree:
      break;
  }
  if (!reason_.isEmpty()) return ManualText::tr("Refused: %1").arg(reason_);
  return ManualText::tr("%1 steers the robot.").arg(QString::fromStdString(active_));
}

}  // namespace widgets
