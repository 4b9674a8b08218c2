// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace widgets {

struct ViewContext;

/// Attaches the commands of the color tool ("color.new", "color.stroke", ...) in the context's command table.
/// They change the documents of colorBench(context) and colorFiles(context), and fail when these no longer
/// exist. They open no dialogs: what would lose unsaved changes is refused. Does nothing if they are attached
/// already.
void addColorCommands(ViewContext& context);

}  // namespace widgets
