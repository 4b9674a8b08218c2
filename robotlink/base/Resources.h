// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "robotlink/base/Error.h"

namespace robotlink {

/// The folder `resources` of this installation: ROBOTCONTROL_RESOURCES if set, else found from the running
/// program: a `resources` folder in or above the program's folder (a build tree), or ../share/robotcontrol
/// (an installed one). An empty path if there is none.
std::filesystem::path resourceDirectory();

/// Fails where resourceDirectory() is none, with a sentence that says what was looked for and how to name it.
Result<void> checkResources();

/// `relative` below resourceDirectory(); it need not exist.
std::filesystem::path resource(const std::filesystem::path& relative);

/// Where the user's own files (window layouts, presets) are kept: $XDG_CONFIG_HOME/robotcontrol, else
/// ~/.config/robotcontrol.
std::filesystem::path userDirectory();

}  // namespace robotlink
