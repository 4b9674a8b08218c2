// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterCommands.h"

#include <QPointer>
#include <functional>
#include <string_view>

#include "robotlink/commands/CommandTable.h"
#include "widgets/solutions/ParameterEdits.h"

namespace widgets {

using robotlink::CommandTable;
using robotlink::Result;
using Values = CommandTable::Values;

void attachParameterCommands(CommandTable& commands, ParameterEdits& edits) {
  if (commands.isAttached("robot.parameter")) return;
  using Run = std::function<Result<void>(ParameterEdits&, const Values&)>;
  const auto attach = [&](const char* name, Run run) {
    const auto act = [run = std::move(run), guard = QPointer(&edits)](const Values& values) -> Result<void> {
      if (guard) return run(*guard, values);
      return robotlink::failure("robot.closed", "the window that edited the parameters is closed");
    };
    const bool hasPath = std::string_view(name).starts_with("robot.");
    const auto offer = [guard = QPointer(&edits), hasPath](const std::vector<std::string>& before) {
      if (!guard || before.size() > (hasPath ? 1 : 0)) return std::vector<std::string>();
      return before.empty() ? guard->solutions() : guard->paths(before.front());
    };
    commands.attach(name, act, offer);
  };
  const auto text = [](const Values& values, std::size_t index) {
    return std::get<std::string>(values[index]);
  };
  attach("robot.parameter", [text](ParameterEdits& to, const Values& values) {
    return to.set(text(values, 0), text(values, 1), text(values, 2));
  });
  attach("robot.reset-parameter", [text](ParameterEdits& to, const Values& values) {
    return to.reset(text(values, 0), text(values, 1));
  });
  attach("parameters.reset",
         [text](ParameterEdits& to, const Values& values) { return to.resetAll(text(values, 0)); });
  attach("parameters.save", [text](ParameterEdits& to, const Values& values) {
    return to.save(text(values, 0), text(values, 1));
  });
}

}  // namespace widgets
