// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace widgets {

struct ViewContext;

/// Adds what can be done to the colour table that is being made to the commands: "color.new", "color.stroke",
/// ... They change what colorBench(context) and colorFiles(context) are of; when these are gone, the commands
/// fail. They ask nothing: what would lose changes is refused. Nothing is added if the commands are there
/// already.
void addColorCommands(ViewContext& context);

}  // namespace widgets
