// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterEdits.h"

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/Requests.h"
#include "widgets/TypedStreams.h"
#include "widgets/solutions/ParameterFile.h"
#include "widgets/solutions/ParameterModel.h"
#include "widgets/solutions/SolutionModel.h"

namespace widgets {
namespace {

using robotcontrol::ParameterValues;
using robotlink::failure;
using robotlink::Result;

/// The paths of all values below an index.
void collectPaths(const ParameterModel& model, const QModelIndex& parent, QStringList& paths) {
  for (int row = 0; row < model.rowCount(parent); ++row) {
    const QModelIndex index = model.index(row, ParameterModel::kField, parent);
    if (model.rowCount(index) == 0) paths << index.data(ParameterModel::kPathRole).toString();
    collectPaths(model, index, paths);
  }
}

/// The index of a value or group; invalid if there is none.
QModelIndex indexOf(const ParameterModel& model, const QString& path, const QModelIndex& parent = {}) {
  for (int row = 0; row < model.rowCount(parent); ++row) {
    const QModelIndex index = model.index(row, ParameterModel::kField, parent);
    if (index.data(ParameterModel::kPathRole).toString() == path) return index;
    if (const QModelIndex below = indexOf(model, path, index); below.isValid()) return below;
  }
  return {};
}

/// The value of a row as set() takes it.
std::string valueOfRow(const QModelIndex& index) {
  const QModelIndex value = index.siblingAtColumn(ParameterModel::kValue);
  const QVariant checked = value.data(Qt::CheckStateRole);
  if (!checked.isValid()) return value.data(Qt::EditRole).toString().toStdString();
  return checked.toInt() == Qt::Checked ? "on" : "off";
}

/// Adds the values that differ from their defaults.
void addChanges(const ParameterValues& values, ParameterEdits::Changes& changes) {
  ParameterModel model;
  if (!model.setParameters(values)) return;
  QStringList paths;
  collectPaths(model, {}, paths);
  for (const QString& path : paths) {
    const QModelIndex index = indexOf(model, path);
    if (index.data(ParameterModel::kChangedRole).toBool())
      changes[values.task() + "/" + values.solution() + " " + path.toStdString()] = valueOfRow(index);
  }
}

bool setValue(ParameterModel& model, const QModelIndex& index, const QString& value) {
  if (!index.data(Qt::CheckStateRole).isValid()) return model.setData(index, value, Qt::EditRole);
  const bool isOn = value == QLatin1String("on") || value == QLatin1String("true");
  if (!isOn && value != QLatin1String("off") && value != QLatin1String("false")) return false;
  return model.setData(index, isOn ? Qt::Checked : Qt::Unchecked, Qt::CheckStateRole);
}

/// The changed message, serialized.
Result<std::string> changed(const ParameterValues& values, const std::string& path,
                            const std::optional<std::string>& value) {
  ParameterModel model;
  if (!model.setParameters(values))
    return failure("robot.parameter-type",
                   "parameters of the type " + values.value().type() + " cannot be read here", {},
                   {values.value().type()});
  const QModelIndex index = indexOf(model, QString::fromStdString(path));
  if (!index.isValid() && (value || !path.empty())) {
    QStringList paths;
    collectPaths(model, {}, paths);
    return failure(
        "robot.parameter-unknown",
        "there is no parameter " + path + "; there are " + paths.join(QStringLiteral(", ")).toStdString(), {},
        {path});
  }
  QByteArray after = model.value();
  QObject::connect(&model, &ParameterModel::edited, &model,
                   [&](const QByteArray&, const QByteArray& edited) { after = edited; });
  if (!value) {
    model.reset(index);
  } else if (!setValue(model, index.siblingAtColumn(ParameterModel::kValue),
                       QString::fromStdString(*value))) {
    const QStringList choices = index.data(ParameterModel::kChoicesRole).toStringList();
    const QString what =
        choices.isEmpty() ? index.data(Qt::ToolTipRole).toString() : choices.join(QStringLiteral(", "));
    return failure("robot.parameter-value", "the value " + *value + " does not fit " + what.toStdString(), {},
                   {path, *value});
  }
  return after.toStdString();
}

}  // namespace

Result<void> ParameterEdits::set(const std::string& solution, const std::string& path,
                                 const std::string& value) {
  return begin(solution, {Edit::What::kSet, {}, path, value});
}

Result<void> ParameterEdits::reset(const std::string& solution, const std::string& path) {
  return begin(solution, {Edit::What::kReset, {}, path});
}

Result<void> ParameterEdits::resetAll(const std::string& solution) {
  return beginAll(solution, {Edit::What::kReset});
}

Result<void> ParameterEdits::save(const std::string& solution, const std::string& file) {
  if (solution.empty() && !file.empty())
    return failure("parameters.file",
                   "one file takes the parameters of one solution; name the solution as well");
  return beginAll(solution, {Edit::What::kSave, {}, file});
}

Result<void> ParameterEdits::beginAll(const std::string& solution, const Edit& edit) {
  if (!solution.empty()) return begin(solution, edit);
  const auto all = solutions();
  if (all.empty())
    return failure("parameters.none", "there is no robot that has reported solutions with parameters");
  for (const std::string& each : all) {
    if (each.find('/') == std::string::npos) continue;  // the active one, which is there by its name, too
    if (auto begun = begin(each, edit); !begun) return begun;
  }
  return {};
}

std::vector<TaskEntry> ParameterEdits::tasks() const {
  return tasksOf(latestTable(session_.store(), session_.selectedRobot(), robotlink::streams::kSolutions,
                             session_.timeline().newest()));
}

std::vector<std::string> ParameterEdits::solutions() const {
  std::vector<std::string> names;
  for (const TaskEntry& task : tasks()) {
    for (const TaskEntry::Solution& solution : task.solutions) {
      if (solution.hasParameters) names.push_back(task.name + "/" + solution.name);
      if (solution.hasParameters && solution.name == task.active) names.push_back(task.name);
    }
  }
  return names;
}

void ParameterEdits::requestChanges(std::function<void(Result<Changes>)> done) {
  struct Answers {
    std::size_t missing = 0;
    Result<Changes> changes;
  };
  const auto answers = std::make_shared<Answers>();
  std::vector<Id> ids;
  for (const std::string& each : solutions()) {
    if (const auto id = find(each); id && each.find('/') != std::string::npos) ids.push_back(*id);
  }
  if (ids.empty()) return done(Changes());
  answers->missing = ids.size();
  for (const Id& id : ids) {
    get(id, [id, answers, done](const ParameterValues* known, const robotcontrol::RequestResult& result) {
      if (known == nullptr) {
        answers->changes =
            failure("robot.parameter", "parameters of " + std::get<1>(id) + ": " + result.reason());
      } else if (answers->changes) {
        addChanges(*known, *answers->changes);
      }
      if (--answers->missing == 0) done(std::move(answers->changes));
    });
  }
}

void ParameterEdits::requestValue(const std::string& solution, const std::string& path,
                                  std::function<void(Result<std::string>)> done) {
  const auto id = find(solution);
  if (!id) return done(tl::unexpected(id.error()));
  get(*id, [path, done = std::move(done)](const ParameterValues* known,
                                          const robotcontrol::RequestResult& result) {
    ParameterModel model;
    if (known == nullptr || !model.setParameters(*known))
      return done(failure("robot.parameter", "the robot did not report its parameters: " + result.reason()));
    const QModelIndex index = indexOf(model, QString::fromStdString(path));
    if (!index.isValid() || model.rowCount(index) > 0)
      return done(failure("robot.parameter-unknown", "there is no parameter " + path, {}, {path}));
    done(valueOfRow(index));
  });
}

void ParameterEdits::get(
    const Id& id, std::function<void(const ParameterValues*, const robotcontrol::RequestResult&)> done) {
  robotcontrol::Request request;
  const auto& [robot, task, name] = id;
  request.set_robot(robot);
  request.mutable_get_parameters()->set_task(task);
  request.mutable_get_parameters()->set_solution(name);
  session_.request(std::move(request), [guard = QPointer(this), id,
                                        done = std::move(done)](const robotcontrol::RequestResult& result) {
    if (guard) done(result.accepted() ? guard->values(id) : nullptr, result);
  });
}

std::vector<std::string> ParameterEdits::paths(const std::string& solution) const {
  std::vector<std::string> result;
  const auto id = find(solution);
  const auto* known = id ? values(*id) : nullptr;
  ParameterModel model;
  if (known == nullptr || !model.setParameters(*known)) return result;
  QStringList paths;
  collectPaths(model, {}, paths);
  for (const QString& path : paths) result.push_back(path.toStdString());
  return result;
}

Result<ParameterEdits::Id> ParameterEdits::find(const std::string& solution) const {
  const std::string& robot = session_.selectedRobot();
  if (robot.empty())
    return failure("robot.none", "there is no robot; open a scene or a log, or connect one first");
  const auto slash = solution.find('/');
  const std::string task = solution.substr(0, slash);
  const auto known = tasks();
  const auto found = std::ranges::find(known, task, &TaskEntry::name);
  if (found == known.end())
    return failure("robot.task-unknown", robot + " has no task " + task, {}, {robot, task});
  const std::string name = slash == std::string::npos ? found->active : solution.substr(slash + 1);
  const auto chosen = std::ranges::find(found->solutions, name, &TaskEntry::Solution::name);
  if (chosen == found->solutions.end())
    return failure("robot.solution-unknown", "the task " + task + " has no solution " + name, {},
                   {task, name});
  if (!chosen->hasParameters)
    return failure("robot.parameter-none", task + "/" + name + " has no parameters", {}, {task, name});
  return Id{robot, task, name};
}

const ParameterValues* ParameterEdits::values(const Id& id) const {
  const auto& [robot, task, solution] = id;
  for (const auto* message :
       latestOfType(session_.store(), robot, "robotcontrol.ParameterValues", session_.timeline().newest())) {
    const auto* values =
        message == nullptr ? nullptr : dynamic_cast<const ParameterValues*>(message->value.get());
    if (values != nullptr && values->task() == task && values->solution() == solution) return values;
  }
  return nullptr;
}

Result<void> ParameterEdits::begin(const std::string& solution, Edit edit) {
  const auto id = find(solution);
  if (!id) return tl::unexpected(id.error());
  edit.id = *id;
  // The values that the robot reported before reveal wrong names and values at once.
  if (const auto* known = values(*id); known != nullptr && edit.what != Edit::What::kSave) {
    const bool isReset = edit.what == Edit::What::kReset;
    if (auto result = changed(*known, edit.path, isReset ? std::nullopt : std::optional(edit.value)); !result)
      return tl::unexpected(result.error());
  }
  get(*id, [this, edit = std::move(edit)](const ParameterValues*, const robotcontrol::RequestResult& result) {
    const auto done =
        result.accepted() ? finish(edit, result.id()) : failure("robot.parameter", result.reason());
    if (done) return;
    const std::string what = edit.path.empty() ? "parameters" : "parameter " + edit.path;
    session_.reportRefusal(what + " of " + std::get<1>(edit.id), done.error().describe());
  });
  return {};
}

Result<ParameterValues> ParameterEdits::current(const Id& id, std::uint64_t asked) const {
  const auto* known = values(id);
  if (known == nullptr) return failure("robot.parameter", "the robot did not report its parameters");
  ParameterValues result = *known;
  const auto sent = sent_.find(id);
  if (sent != sent_.end() && sent->second.request > asked)
    result.mutable_value()->set_data(sent->second.value);
  return result;
}

Result<void> ParameterEdits::finish(const Edit& edit, std::uint64_t asked) {
  const auto base = current(edit.id, asked);
  if (!base) return tl::unexpected(base.error());
  if (edit.what == Edit::What::kSave) return finishSave(edit, *base);
  const bool isReset = edit.what == Edit::What::kReset;
  auto value = changed(*base, edit.path, isReset ? std::nullopt : std::optional(edit.value));
  if (!value) return tl::unexpected(value.error());
  if (isReset && *value == base->value().data()) return {};
  robotcontrol::Request request;
  const auto& [robot, task, solution] = edit.id;
  request.set_robot(robot);
  auto& set = *request.mutable_set_parameters();
  set.set_task(task);
  set.set_solution(solution);
  set.mutable_value()->set_type(base->value().type());
  set.mutable_value()->set_data(*value);
  sent_[edit.id] = {session_.request(std::move(request)), std::move(*value)};
  return {};
}

Result<void> ParameterEdits::finishSave(const Edit& edit, const ParameterValues& values) {
  ParameterModel model;
  if (!model.setParameters(values))
    return failure("robot.parameter-type",
                   "parameters of the type " + values.value().type() + " cannot be read here", {},
                   {values.value().type()});
  if (!edit.path.empty()) return saveParameters(model, edit.path);
  if (!model.isChanged()) return {};
  const std::string& robot = std::get<0>(edit.id);
  const auto file = parameterFileHere(session_, robot, values);
  if (!file) return tl::unexpected(file.error());
  if (auto saved = saveParameters(model, *file); !saved) return saved;
  robotcontrol::Request request = savedParameters(model, values);
  request.set_robot(robot);
  sent_[edit.id] = {session_.request(std::move(request)), model.value().toStdString()};
  return {};
}

}  // namespace widgets
