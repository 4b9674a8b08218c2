// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace robotlink {

/// Returns the file that is written if `path` is opened: `path` itself or, if it is a symbolic link, what it
/// points to over any number of links, even if that does not exist yet. For links in a circle it returns one
/// of them.
std::filesystem::path linkTarget(std::filesystem::path path);

}  // namespace robotlink
