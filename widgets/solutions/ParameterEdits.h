// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class ParameterValues;
class RequestResult;
}  // namespace robotcontrol
namespace robotlink {
class Session;
}

namespace widgets {

struct TaskEntry;

/// Sets, resets and saves parameters of the selected robot's solutions, for commands; the panel of parameters
/// edits whole messages. Requests the current values, changes one field as ParameterModel does, and sends the
/// message back. Several edits of a solution may be on their way: each changes what the one before has sent.
///
/// What is wrong in the names of task and solution fails at once; what only the robot's values can show is
/// wrong is passed to the session's refusal handler. GUI thread; the session must outlive it.
class ParameterEdits final : public QObject {
  Q_OBJECT
 public:
  explicit ParameterEdits(robotlink::Session& session, QObject* parent = nullptr)
      : QObject(parent), session_(session) {}

  /// `solution`: a task ("walking"), which means its active solution, or with one ("walking/gait"). `path`:
  /// "step.height"; for reset() also a group of parameters, or empty for all of them. `value` as a person
  /// types it; bools are on or off.
  robotlink::Result<void> set(const std::string& solution, const std::string& path, const std::string& value);
  robotlink::Result<void> reset(const std::string& solution, const std::string& path);
  /// Saves what was changed of a solution to the file that the program reads at its start, or to `file`. An
  /// empty `solution` means all, which only their own files can take.
  robotlink::Result<void> save(const std::string& solution, const std::string& file);
  /// Resets all parameters of a solution, or of all if `solution` is empty.
  robotlink::Result<void> resetAll(const std::string& solution);
  /// Requests the values of all solutions, and calls `done` in a tick of the session with those that differ
  /// from their defaults: "walking/gait step.height" -> "0.03". Fails if the robot does not report them.
  using Changes = std::map<std::string, std::string>;
  void requestChanges(std::function<void(robotlink::Result<Changes>)> done);
  /// Requests a value, and calls `done` in a tick of the session with it as set() takes it. Fails if the
  /// robot has no such parameter.
  void requestValue(const std::string& solution, const std::string& path,
                    std::function<void(robotlink::Result<std::string>)> done);
  /// The names accepted as a solution: tasks, and their solutions that have parameters.
  std::vector<std::string> solutions() const;
  /// The paths of the parameters of a solution, as far as the robot has reported them.
  std::vector<std::string> paths(const std::string& solution) const;

 private:
  /// Robot, task, solution.
  using Id = std::tuple<std::string, std::string, std::string>;
  struct Edit {
    enum class What { kSet, kReset, kSave };
    What what = What::kSet;
    Id id = {};
    /// A parameter; when saving, the file, or empty for the program's own.
    std::string path = {};
    std::string value = {};
  };
  /// The last message that was sent for a solution.
  struct Sent {
    std::uint64_t request = 0;
    std::string value;
  };

  robotlink::Result<void> begin(const std::string& solution, Edit edit);
  /// Requests the parameters of a solution; `done` gets them, which are null if the robot did not report any.
  void get(
      const Id& id,
      std::function<void(const robotcontrol::ParameterValues*, const robotcontrol::RequestResult&)> done);
  /// The tasks that the selected robot reported last.
  std::vector<TaskEntry> tasks() const;
  robotlink::Result<Id> find(const std::string& solution) const;
  /// The values that the robot reported last; null: none.
  const robotcontrol::ParameterValues* values(const Id& id) const;
  robotlink::Result<void> beginAll(const std::string& solution, const Edit& edit);
  /// The values that the robot has, or will have after what was sent; `asked` is the request for the values.
  robotlink::Result<robotcontrol::ParameterValues> current(const Id& id, std::uint64_t asked) const;
  /// Sends the changed message, or writes it to a file.
  robotlink::Result<void> finish(const Edit& edit, std::uint64_t asked);
  robotlink::Result<void> finishSave(const Edit& edit, const robotcontrol::ParameterValues& values);

  robotlink::Session& session_;
  std::map<Id, Sent> sent_;
};

}  // namespace widgets
