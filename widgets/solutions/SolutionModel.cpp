// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/SolutionModel.h"

#include <QFont>
#include <QGuiApplication>
#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/Theme.h"

namespace widgets {
namespace {

QStringList namesOf(const google::protobuf::RepeatedPtrField<std::string>& packages) {
  QStringList names;
  for (const std::string& package : packages) names << QString::fromStdString(package);
  return names;
}

TaskEntry taskEntry(const robotcontrol::SolutionTable::Task& from) {
  TaskEntry task;
  task.name = from.name();
  task.process = from.process();
  task.active = from.active();
  task.standard = from.default_solution();
  task.help = QString::fromStdString(from.help());
  for (const auto& solution : from.solutions()) {
    task.solutions.push_back({solution.name(), QString::fromStdString(solution.help()),
                              QString::fromStdString(solution.unavailable()), solution.has_parameters(),
                              namesOf(solution.required_inputs()), namesOf(solution.optional_inputs()),
                              namesOf(solution.outputs())});
  }
  return task;
}

bool sameShape(const std::vector<TaskEntry>& a, const std::vector<TaskEntry>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const TaskEntry& x, const TaskEntry& y) {
    return x.name == y.name &&
           std::equal(x.solutions.begin(), x.solutions.end(), y.solutions.begin(), y.solutions.end(),
                      [](const auto& s, const auto& t) { return s.name == t.name; });
  });
}

/// Returns the time between a process's frames, s; 0 if that is not known. Its times may come less
/// often than its frames.
double periodOf(const robotlink::StreamStore& store, const std::string& robot, const std::string& process,
                robotlink::Instant from, robotlink::Instant until) {
  const auto* stream = store.find(robot + '/' + robotlink::streams::kFrames + process);
  if (stream == nullptr) return 0;
  const robotlink::StreamMessage* newest = nullptr;
  const robotlink::StreamMessage* oldest = nullptr;
  for (auto message = stream->messages.rbegin(); message != stream->messages.rend(); ++message) {
    if (message->time > until) continue;
    if (message->time < from) break;
    if (newest == nullptr) newest = &*message;
    oldest = &*message;
  }
  const auto numberOf = [](const robotlink::StreamMessage* message) {
    const auto* frame =
        message == nullptr ? nullptr : dynamic_cast<const robotcontrol::FrameInfo*>(message->value.get());
    return frame == nullptr ? 0.0 : static_cast<double>(frame->number());
  };
  const double frames = numberOf(newest) - numberOf(oldest);
  return frames > 0 ? robotlink::seconds(newest->time - oldest->time) / frames : 0;
}

}  // namespace

std::vector<TaskEntry> tasksOf(const std::vector<const robotlink::StreamMessage*>& tables) {
  std::vector<TaskEntry> tasks;
  for (const auto* message : tables) {
    if (message == nullptr) continue;
    const auto* table = dynamic_cast<const robotcontrol::SolutionTable*>(message->value.get());
    if (table == nullptr) continue;
    for (const auto& task : table->tasks()) tasks.push_back(taskEntry(task));
  }
  return tasks;
}

std::set<TaskSolution> shadowsOf(const std::vector<const robotlink::StreamMessage*>& tables) {
  std::set<TaskSolution> shadows;
  for (const auto* message : tables) {
    if (message == nullptr) continue;
    const auto* table = dynamic_cast<const robotcontrol::KeyTable*>(message->value.get());
    if (table == nullptr) continue;
    for (const auto& key : table->keys()) {
      const auto shadow = robotlink::shadowOfKey(key.name());
      if (shadow && key.mode().kind() != robotcontrol::KeyMode::OFF)
        shadows.emplace(shadow->task, shadow->solution);
    }
  }
  return shadows;
}

std::map<TaskSolution, SolutionCost> costsOf(const robotlink::StreamStore& store, const std::string& robot,
                                             const std::vector<TaskEntry>& tasks, robotlink::Instant until) {
  constexpr robotlink::Duration kSpan = std::chrono::seconds(2);
  std::map<TaskSolution, SolutionCost> costs;
  std::set<std::string> processes;
  for (const TaskEntry& task : tasks) processes.insert(task.process);
  for (const std::string& process : processes) {
    const auto* stream = store.find(robot + '/' + robotlink::streams::kStopwatches + process);
    if (stream == nullptr) continue;
    std::map<TaskSolution, int> runs;
    for (auto message = stream->messages.rbegin(); message != stream->messages.rend(); ++message) {
      if (message->time > until) continue;
      if (message->time < until - kSpan) break;
      const auto* times = dynamic_cast<const robotcontrol::StopwatchTimes*>(message->value.get());
      if (times == nullptr) continue;
      for (const auto& entry : times->entries()) {
        // "kalman (shadow)"
        const TaskSolution solution{entry.task(), entry.solution().substr(0, entry.solution().find(' '))};
        costs[solution].mean += entry.seconds();
        ++runs[solution];
      }
    }
    const double period = periodOf(store, robot, process, until - kSpan, until);
    for (const auto& [solution, count] : runs) {
      SolutionCost& cost = costs[solution];
      cost.mean /= count;
      cost.share = period > 0 ? cost.mean / period : 0;
    }
  }
  return costs;
}

void SolutionModel::setTasks(std::vector<TaskEntry> tasks) {
  for (const TaskEntry& task : tasks) {
    firstActive_.emplace(task.name, task.active);
    const auto pending = pending_.find(task.name);
    if (pending != pending_.end() && pending->second == task.active) pending_.erase(pending);
    const auto refusal = refusals_.find(task.name);
    if (refusal != refusals_.end() && refusal->second.solution == task.active) refusals_.erase(refusal);
  }
  if (!sameShape(tasks, tasks_)) {
    beginResetModel();
    tasks_ = std::move(tasks);
    endResetModel();
    return;
  }
  tasks_ = std::move(tasks);
  for (const TaskEntry& task : tasks_) taskChanged(task.name);
}

void SolutionModel::setShadows(std::set<TaskSolution> shadows) {
  shadows_ = std::move(shadows);
  pendingShadows_.clear();
  for (const TaskEntry& task : tasks_) taskChanged(task.name);
}

void SolutionModel::setCosts(std::map<TaskSolution, SolutionCost> costs) {
  if (costs == costs_) return;
  costs_ = std::move(costs);
  for (int row = 0; row < rowCount({}); ++row) {
    const QModelIndex task = index(row, 0);
    if (const int solutions = rowCount(task); solutions > 0)
      Q_EMIT dataChanged(index(0, kCost, task), index(solutions - 1, kCost, task));
  }
}

void SolutionModel::refuseShadow(const TaskSolution& shadow) {
  pendingShadows_.erase(shadow);
  taskChanged(shadow.first);
}

void SolutionModel::forget() {
  pendingShadows_.clear();
  pending_.clear();
  refusals_.clear();
}

void SolutionModel::setPending(const std::string& task, const std::string& solution) {
  pending_[task] = solution;
  refusals_.erase(task);
  taskChanged(task);
}

void SolutionModel::refuse(const std::string& task, const std::string& solution, const QString& reason) {
  pending_.erase(task);
  refusals_[task] = {solution, reason};
  taskChanged(task);
}

std::string SolutionModel::standardOf(const TaskEntry& task) const {
  if (!task.standard.empty()) return task.standard;
  const auto first = firstActive_.find(task.name);
  return first == firstActive_.end() ? task.active : first->second;
}

void SolutionModel::taskChanged(const std::string& task) {
  for (int row = 0; row < static_cast<int>(tasks_.size()); ++row) {
    if (tasks_[static_cast<std::size_t>(row)].name != task) continue;
    const QModelIndex parent = index(row, 0);
    Q_EMIT dataChanged(parent, index(row, kState));
    if (rowCount(parent) > 0) {
      Q_EMIT dataChanged(index(0, 0, parent), index(rowCount(parent) - 1, kState, parent));
    }
  }
}

// The internal id of a task's index is 0, that of a solution's index its task's row + 1.
QModelIndex SolutionModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : 0);
}

QModelIndex SolutionModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == 0) return {};
  return createIndex(static_cast<int>(child.internalId()) - 1, 0, quintptr{0});
}

int SolutionModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(tasks_.size());
  if (parent.internalId() != 0 || parent.column() > 0) return 0;
  return static_cast<int>(tasks_[static_cast<std::size_t>(parent.row())].solutions.size());
}

int SolutionModel::columnCount(const QModelIndex&) const {
  return kColumns;
}

SolutionModel::Choice SolutionModel::choiceOf(const TaskEntry& task,
                                              const TaskEntry::Solution& solution) const {
  const auto pending = pending_.find(task.name);
  if (pending != pending_.end() && pending->second == solution.name) return Choice::kPending;
  if (solution.name == task.active) return Choice::kActive;
  return solution.unavailable.isEmpty() ? Choice::kFree : Choice::kUnavailable;
}

QVariant SolutionModel::shadowOf(const TaskEntry& task, const TaskEntry::Solution& solution) const {
  if (task.solutions.size() < 2 || !solution.unavailable.isEmpty()) return {};
  const TaskSolution shadow{task.name, solution.name};
  const auto pending = pendingShadows_.find(shadow);
  const bool on = pending != pendingShadows_.end() ? pending->second : shadows_.contains(shadow);
  return on ? Qt::Checked : Qt::Unchecked;
}

QString SolutionModel::costOf(const TaskEntry& task, const TaskEntry::Solution& solution) const {
  const auto cost = costs_.find({task.name, solution.name});
  if (cost == costs_.end()) return {};
  const double seconds = cost->second.mean;
  const QString mean =
      seconds < 1e-4 ? tr("%1 µs").arg(1e6 * seconds, 0, 'f', 0) : tr("%1 ms").arg(1e3 * seconds, 0, 'f', 2);
  return cost->second.share > 0 ? tr("%1, %2 %").arg(mean).arg(100 * cost->second.share, 0, 'f', 1) : mean;
}

QString SolutionModel::stateOf(const TaskEntry& task, const TaskEntry::Solution& solution) const {
  const auto refusal = refusals_.find(task.name);
  if (refusal != refusals_.end() && refusal->second.solution == solution.name) {
    return tr("refused: %1").arg(refusal->second.reason);
  }
  if (choiceOf(task, solution) == Choice::kPending) return tr("switching…");
  // The rest of the help is whose method it is.
  return solution.unavailable.isEmpty() ? solution.help.section(QLatin1Char('\n'), 0, 0)
                                        : solution.unavailable;
}

QString SolutionModel::packagesOf(const TaskEntry::Solution& solution) {
  QStringList lines;
  const auto add = [&](const QString& line, const QStringList& packages) {
    if (!packages.isEmpty()) lines << line.arg(packages.join(QStringLiteral(", ")));
  };
  add(tr("reads %1"), solution.required);
  add(tr("reads if offered %1"), solution.optional);
  add(tr("publishes %1"), solution.outputs);
  return lines.join(QLatin1Char('\n'));
}

QVariant SolutionModel::taskData(const TaskEntry& task, int column, int role) const {
  if (role == kTaskRole) return QString::fromStdString(task.name);
  if (role == Qt::ToolTipRole) {
    const auto active = std::ranges::find(task.solutions, task.active, &TaskEntry::Solution::name);
    const QString packages = active == task.solutions.end() ? QString() : packagesOf(*active);
    return packages.isEmpty() ? task.help : QStringLiteral("%1\n\n%2").arg(task.help, packages);
  }
  if (role == Qt::FontRole) {
    QFont font;
    font.setBold(column == kName);
    return font;
  }
  if (role != Qt::DisplayRole) return {};
  if (column == kName) return QString::fromStdString(task.name);
  if (column == kProcess) return QString::fromStdString(task.process);
  if (column == kShadow || column == kCost) return {};
  const auto pending = pending_.find(task.name);
  const QString active = task.active.empty() ? tr("nothing") : QString::fromStdString(task.active);
  return pending == pending_.end() ? active
                                   : tr("%1 → %2…").arg(active, QString::fromStdString(pending->second));
}

QVariant SolutionModel::solutionData(const TaskEntry& task, const TaskEntry::Solution& solution, int column,
                                     int role) const {
  const auto refusal = refusals_.find(task.name);
  const bool refused = refusal != refusals_.end() && refusal->second.solution == solution.name;
  if (column == kShadow && role == Qt::CheckStateRole) return shadowOf(task, solution);
  if (column == kShadow && role == Qt::ToolTipRole && shadowOf(task, solution).isValid())
    return tr("Runs %1 in the shadow of the active solution, on the same "
              "inputs and without being used. What it publishes is "
              "under shadow/%1; its computing time is in the next column.")
        .arg(QString::fromStdString(solution.name));
  switch (role) {
    case kTaskRole:
      return QString::fromStdString(task.name);
    case kSolutionRole:
      return QString::fromStdString(solution.name);
    case kChoiceRole:
      return static_cast<int>(choiceOf(task, solution));
    case kParametersRole:
      return solution.hasParameters;
    case Qt::DisplayRole:
      if (column == kName) return QString::fromStdString(solution.name);
      if (column == kCost) return costOf(task, solution);
      return column == kState ? stateOf(task, solution) : QString();
    case Qt::ToolTipRole: {
      QStringList lines{solution.help, refused ? stateOf(task, solution) : solution.unavailable};
      const QString packages = packagesOf(solution);
      lines.removeAll(QString());
      if (!packages.isEmpty()) lines << QString() << packages;
      return lines.join(QLatin1Char('\n'));
    }
    case Qt::ForegroundRole:
      if (refused) return colorOf(Meaning::kBad, QGuiApplication::palette());
      if (choiceOf(task, solution) == Choice::kUnavailable || column != kName) {
        return colorOf(Meaning::kMuted, QGuiApplication::palette());
      }
      return {};
    default:
      return {};
  }
}

QVariant SolutionModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (index.internalId() == 0) {
    return taskData(tasks_[static_cast<std::size_t>(index.row())], index.column(), role);
  }
  const TaskEntry& task = tasks_[index.internalId() - 1];
  return solutionData(task, task.solutions[static_cast<std::size_t>(index.row())], index.column(), role);
}

bool SolutionModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || !data(index, role).isValid()) return false;
  const TaskEntry& task = tasks_[index.internalId() - 1];
  const std::string& solution = task.solutions[static_cast<std::size_t>(index.row())].name;
  const bool on = value.toInt() == Qt::Checked;
  pendingShadows_[{task.name, solution}] = on;
  Q_EMIT dataChanged(index, index, {role});
  Q_EMIT shadowRequested(task.name, solution, on);
  return true;
}

Qt::ItemFlags SolutionModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractItemModel::flags(index);
  return data(index, Qt::CheckStateRole).isValid() ? flags | Qt::ItemIsUserCheckable : flags;
}

QVariant SolutionModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::ToolTipRole && section == kCost)
    return tr(
        "Mean time of a frame and share of the process's period, in the last two seconds, while the robot "
        "measures its tasks (Measure in the view Timing)");
  if (role != Qt::DisplayRole) return {};
  if (section == kShadow) return tr("Shadow");
  if (section == kCost) return tr("Cost");
  return section == kName ? tr("Task and solutions") : section == kProcess ? tr("Process") : tr("State");
}

}  // namespace widgets
