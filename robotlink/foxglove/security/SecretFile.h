// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotlink::websocket {

/// Returns the folder of the programs' private files (keys, tokens, known robots):
/// $XDG_STATE_HOME/robotcontrol, otherwise ~/.local/state/robotcontrol, otherwise a folder below the system's
/// temporary one. It is not created.
std::filesystem::path stateDirectory();

/// Reads a file that only its owner may read. Fails if others may (secret.readable), if it belongs to
/// another user, or as readFile() does.
Result<std::string> readSecret(const std::filesystem::path& path);

/// Creates a file that only its owner may read and write, as a whole; missing folders are created. Returns
/// false if there is such a file already, perhaps made by another program at the same time: that one is left
/// as it is.
Result<bool> createSecret(const std::filesystem::path& path, std::string_view contents);

/// The same in the place of the file that there is.
Result<void> replaceSecret(const std::filesystem::path& path, std::string_view contents);

}  // namespace robotlink::websocket
