// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "robotlink/base/Error.h"

namespace app {

/// Lets this program use a resource folder of the robot's own instead of the installed one, from which it is
/// copied if it does not exist or is empty. Call this before anything reads resources or starts a thread.
robotlink::Result<void> useOwnResources(const std::filesystem::path& folder);

}  // namespace app
