// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <QStringList>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotlink {
struct StreamMessage;
class StreamStore;
}  // namespace robotlink

namespace widgets {

/// A task of a robot and the solutions that exist for it.
struct TaskEntry {
  /// A solution of the task.
  struct Solution {
    std::string name;
    QString help;
    /// The reason why it cannot be chosen; empty: it can.
    QString unavailable;
    bool hasParameters = false;
    /// The packages that it reads: those without which it cannot run, and those that it uses if they are
    /// offered; and those that it publishes. All are empty if the robot does not say.
    QStringList required = {}, optional = {}, outputs = {};
    bool operator==(const Solution&) const = default;
  };
  std::string name;
  /// The process that executes the task.
  std::string process;
  /// The solution that runs; empty: none.
  std::string active;
  /// The layout's default solution; empty if the robot does not publish it.
  std::string standard;
  QString help;
  std::vector<Solution> solutions;
  bool operator==(const TaskEntry&) const = default;
};

/// The tasks in all messages that are SolutionTables, in the order of the tables; null messages are skipped.
std::vector<TaskEntry> tasksOf(const std::vector<const robotlink::StreamMessage*>& tables);

/// A task and one of its solutions.
using TaskSolution = std::pair<std::string, std::string>;

/// The solutions that run in the shadow of the active ones, according to all messages that are KeyTables;
/// null messages are skipped.
std::set<TaskSolution> shadowsOf(const std::vector<const robotlink::StreamMessage*>& tables);

/// The real time that a solution takes of a process, whether it is active or in shadow mode.
struct SolutionCost {
  /// In s, for each frame in which it ran.
  double mean = 0;
  /// Its share of the period of its process, 0 to 1 if that keeps its rate; 0: not known.
  double share = 0;
  bool operator==(const SolutionCost&) const = default;
};

/// The costs of solutions of these tasks in the last two seconds before an instant, of those that a robot has
/// measured.
std::map<TaskSolution, SolutionCost> costsOf(const robotlink::StreamStore& store, const std::string& robot,
                                             const std::vector<TaskEntry>& tasks, robotlink::Instant until);

/// Tasks as rows with their solutions below them. A solution that was requested is shown as pending until a
/// table confirms it; a refusal and its reason are shown at the solution until the task gets another request.
/// GUI thread.
class SolutionModel final : public QAbstractItemModel {
  Q_OBJECT
 public:
  /// Name, a check box for running in shadow mode (solutions that can be chosen), cost (solutions that run
  /// and are measured), process (tasks only), and state.
  enum Column { kName, kShadow, kCost, kProcess, kState, kColumns };
  enum Role {
    /// The task's name, for its solutions as well (QString).
    kTaskRole = Qt::UserRole + 1,
    /// The solution's name (QString); invalid for tasks.
    kSolutionRole,
    /// Choice as int; invalid for tasks.
    kChoiceRole,
    /// Whether the solution has parameters (bool); invalid for tasks.
    kParametersRole,
  };
  /// kFree: can be chosen; kActive: runs; kPending: requested; kUnavailable: cannot be chosen.
  enum class Choice { kFree, kActive, kPending, kUnavailable };

  using QAbstractItemModel::QAbstractItemModel;

  /// Replaces the tasks and settles pending solutions that run now. Rows, and so selection and expansion, are
  /// kept if the names are the same.
  void setTasks(std::vector<TaskEntry> tasks);
  const std::vector<TaskEntry>& tasks() const { return tasks_; }
  /// Forgets what was requested and refused; call this before the tasks of another robot are set.
  void forget();
  /// Replaces what runs in shadow mode; what was requested counts until then.
  void setShadows(std::set<TaskSolution> shadows);
  /// Replaces what solutions cost.
  void setCosts(std::map<TaskSolution, SolutionCost> costs);
  /// The request for a shadow was refused.
  void refuseShadow(const TaskSolution& shadow);
  /// The solution was requested.
  void setPending(const std::string& task, const std::string& solution);
  /// The request was refused.
  void refuse(const std::string& task, const std::string& solution, const QString& reason);
  /// The task's default solution: the layout's or, if the robot does not publish it, the one that ran when
  /// the model first saw the task.
  std::string standardOf(const TaskEntry& task) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// Checks or unchecks the box of a solution, which requests its shadow.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 Q_SIGNALS:
  /// The user wants a solution to run in the shadow of the active one, or no longer.
  void shadowRequested(const std::string& task, const std::string& solution, bool on);

 private:
  QVariant taskData(const TaskEntry& task, int column, int role) const;
  QVariant solutionData(const TaskEntry& task, const TaskEntry::Solution& solution, int column,
                        int role) const;
  /// The packages that a solution reads and publishes, a line each; empty if the robot does not report them.
  static QString packagesOf(const TaskEntry::Solution& solution);
  Choice choiceOf(const TaskEntry& task, const TaskEntry::Solution& solution) const;
  /// Whether the box of a solution is checked; invalid for one without a box.
  QVariant shadowOf(const TaskEntry& task, const TaskEntry::Solution& solution) const;
  /// Text of the column kCost; empty: it does not run, or is not measured.
  QString costOf(const TaskEntry& task, const TaskEntry::Solution& solution) const;
  /// Text of the column kState.
  QString stateOf(const TaskEntry& task, const TaskEntry::Solution& solution) const;
  /// Announces changed data of a task and its solutions.
  void taskChanged(const std::string& task);

  /// The last refusal of a task.
  struct Refusal {
    std::string solution;
    QString reason;
  };
  std::vector<TaskEntry> tasks_;
  std::set<TaskSolution> shadows_;
  std::map<TaskSolution, SolutionCost> costs_;
  /// The requests for shadows since they were set.
  std::map<TaskSolution, bool> pendingShadows_;
  /// Requested solutions, by task.
  std::map<std::string, std::string> pending_;
  /// Keyed by task.
  std::map<std::string, Refusal> refusals_;
  /// The solutions that ran first, by task; see standardOf().
  std::map<std::string, std::string> firstActive_;
};

}  // namespace widgets
