// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <map>
#include <string>
#include <vector>

namespace robotlink {
struct StreamMessage;
}

namespace widgets {

/// A task of a robot with the solutions that exist for it.
struct TaskEntry {
  struct Solution {
    std::string name;
    QString help;
    QString unavailable;  ///< empty: it can be chosen
    bool hasParameters = false;
    bool operator==(const Solution&) const = default;
  };
  std::string name;
  std::string process;
  std::string active;
  std::string standard;  ///< the layout's default; empty if the robot does not tell it
  QString help;
  std::vector<Solution> solutions;
  bool operator==(const TaskEntry&) const = default;
};

/// The tasks of all these messages that are SolutionTables (null ones are skipped), in the order of the
/// tables.
std::vector<TaskEntry> tasksOf(const std::vector<const robotlink::StreamMessage*>& tables);

/// Tasks as rows, their solutions below them. Columns: name, process, state. What was asked for and is not
/// yet confirmed is shown as such; a refusal stays at its solution, with its reason, until something else is
/// asked of the task. GUI thread.
class SolutionModel final : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { kName, kProcess, kState, kColumns };
  enum Role {
    kTaskRole = Qt::UserRole + 1,  ///< the task's name, at its solutions too
    kSolutionRole,                 ///< the solution's name; invalid at tasks
    kChoiceRole,                   ///< Choice as int; invalid at tasks
    kParametersRole,               ///< bool: it has parameters
  };
  enum class Choice { kFree, kActive, kPending, kUnavailable };

  using QAbstractItemModel::QAbstractItemModel;

  void setTasks(std::vector<TaskEntry> tasks);
  const std::vector<TaskEntry>& tasks() const { return tasks_; }
  /// Asked for, not yet confirmed.
  void setPending(const std::string& task, const std::string& solution);
  void refuse(const std::string& task, const std::string& solution, const QString& reason);
  /// What the task would run by default: what its robot says, else what it ran when it was first seen.
  std::string standardOf(const TaskEntry& task) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVariant taskData(const TaskEntry& task, int column, int role) const;
  QVariant solutionData(const TaskEntry& task, const TaskEntry::Solution& solution, int column,
                        int role) const;
  Choice choiceOf(const TaskEntry& task, const TaskEntry::Solution& solution) const;
  QString stateOf(const TaskEntry& task, const TaskEntry::Solution& solution) const;
  void taskChanged(const std::string& task);

  struct Refusal {
    std::string solution;
    QString reason;
  };
  std::vector<TaskEntry> tasks_;
  std::map<std::string, std::string> pending_;      // by task
  std::map<std::string, Refusal> refusals_;         // by task
  std::map<std::string, std::string> firstActive_;  // by task
};

}  // namespace widgets
