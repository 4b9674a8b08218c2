// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace widgets {

struct ViewContext;

/// Attaches scene.edit and scene.save, which act on the window's scene editor. They fail once the window no
/// longer exists. Does nothing if they are attached already.
void attachSceneEditorCommands(ViewContext& context);

}  // namespace widgets
