// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace widgets {

struct ViewContext;

/// Adds the commands of the color tool ("color.new", "color.stroke", ...) to the context's command table.
/// They change the documents of colorBench(context) and colorFiles(context), and fail when these are gone.
/// They open no dialogs: what would lose unsaved changes is refused. Does nothing if the commands are there
/// already.
void addColorCommands(ViewContext& context);

}  // namespace widgets
