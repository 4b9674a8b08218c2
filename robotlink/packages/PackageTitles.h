// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotlink {

/// The name of a package for users: "joint angles (joints/states)"; the bare name if the package is unknown
/// here.
std::string packageTitle(const std::string& package);

/// The reason that a task cannot run for lack of a package: neither the platform nor another task provides
/// it.
std::string notProvided(const std::string& package);

}  // namespace robotlink
