// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotlink {

/// Writes a file so that it is there as a whole or not at all: to a temporary neighbour, flushed to the disk,
/// then renamed. A full disk, a missing right or a signal that ends the program leaves the old file as it
/// was. Where `path` is a symbolic link, the file that it points to is written.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view contents);

/// A whole file; fails if it cannot be read or is larger than `maxBytes`.
Result<std::string> readFile(const std::filesystem::path& path, std::size_t maxBytes = 64U << 20U);

}  // namespace robotlink
