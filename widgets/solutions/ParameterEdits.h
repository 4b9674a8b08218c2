// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class ParameterValues;
}
namespace robotlink {
class Session;
}

namespace widgets {

struct TaskEntry;

/// Sets and resets single parameters of the selected robot's solutions, for commands; the panel of parameters
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
  /// What may be given as a solution: tasks, and their solutions that have parameters.
  std::vector<std::string> solutions() const;

 private:
  /// Robot, task, solution.
  using Id = std::tuple<std::string, std::string, std::string>;
  struct Edit {
    Id id;
    std::string path;
    /// Unset: the default.
    std::optional<std::string> value;
  };
  /// The last message that was sent for a solution.
  struct Sent {
    std::uint64_t request = 0;
    std::string value;
  };

  robotlink::Result<void> begin(const std::string& solution, Edit edit);
  /// What the selected robot reported last of its tasks.
  std::vector<TaskEntry> tasks() const;
  robotlink::Result<Id> find(const std::string& solution) const;
  /// What the robot said last; null: nothing.
  const robotcontrol::ParameterValues* values(const Id& id) const;
  /// Sends the changed message; `asked` is the request for the values.
  robotlink::Result<void> finish(const Edit& edit, std::uint64_t asked);

  robotlink::Session& session_;
  std::map<Id, Sent> sent_;
};

}  // namespace widgets
