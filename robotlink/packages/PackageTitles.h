// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotlink {

/// A package for people who do not know the code: "joint angles (joints/states)"; the name alone of one that
/// is not known here.
std::string packageTitle(const std::string& package);

/// Why a task that needs a package cannot run: neither the platform nor another task yields it.
std::string notProvided(const std::string& package);

}  // namespace robotlink
