// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace robotlink {

/// The file that is written where `path` is named: `path` itself, or what it points to as a symbolic link,
/// over other links, also if that is not there yet. Of links in a circle one of them.
std::filesystem::path linkTarget(std::filesystem::path path);

}  // namespace robotlink
