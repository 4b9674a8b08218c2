// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {
class CommandTable;
}

namespace widgets {

class ParameterEdits;

/// Attaches the commands that set, reset and save parameters of solutions ("robot.parameter", ...,
/// "parameters.save"). They fail when `edits` no longer exists. Does nothing if they are attached already.
void attachParameterCommands(robotlink::CommandTable& commands, ParameterEdits& edits);

}  // namespace widgets
