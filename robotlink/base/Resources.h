// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "robotlink/base/Error.h"

namespace robotlink {

/// The folder `resources` of this installation: $ROBOTCONTROL_RESOURCES if it is set; otherwise a `resources`
/// folder in or above the program's folder (a build tree), or ../share/robotcontrol (an installation). An
/// empty path if there is none.
std::filesystem::path resourceDirectory();

/// Fails if resourceDirectory() is not usable; the error says where it was searched and how to set it.
Result<void> checkResources();

/// The path of a file below resourceDirectory(); the file need not exist.
std::filesystem::path resource(const std::filesystem::path& relative);

/// The path of a file that is not among the sources but made by the build: as resource() in an installation,
/// in or above the program's folder in a build tree. The file need not exist.
std::filesystem::path builtResource(const std::filesystem::path& relative);

/// A variable of the environment; null if it is not set, or empty.
const char* environmentValue(const char* name);

/// The folder of the user's own files (window layouts, presets): $XDG_CONFIG_HOME/robotcontrol, otherwise
/// ~/.config/robotcontrol, otherwise a folder below the system's temporary one. It is not created.
std::filesystem::path userDirectory();

}  // namespace robotlink
