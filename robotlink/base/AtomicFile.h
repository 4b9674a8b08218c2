// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotlink {

/// Writes a file as a whole or not at all. The contents go to a temporary file beside the target, are flushed
/// to the disk and then renamed, so that a full disk, missing permissions or a signal that ends the program
/// leave the old file as it was. Missing parent folders are created. If `path` is a symbolic link, the file
/// that it points to is written. Errors: file.io.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view contents);

/// Reads a whole file, or what is written into a pipe until its writer closes it. Fails if it cannot be
/// opened or read, or is a pipe without data for `pipePatience` (file.io); if it is a directory
/// (file.directory); if it is larger than `maxBytes` (file.too-large).
Result<std::string> readFile(const std::filesystem::path& path, std::size_t maxBytes = 64U << 20U,
                             std::chrono::milliseconds pipePatience = std::chrono::seconds(10));

}  // namespace robotlink
