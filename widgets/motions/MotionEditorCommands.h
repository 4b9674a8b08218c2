// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace widgets {

struct ViewContext;

/// Attaches the commands of the motion editor ("motion.open", "motion.send", ...) and of single joints
/// ("joints.set", "joints.capture", ...) in the context's command table. They open no dialogs: what would
/// lose unsaved changes is refused. Does nothing if they are attached already.
void attachMotionEditorCommands(ViewContext& context);

}  // namespace widgets
