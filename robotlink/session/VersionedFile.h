// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "robotlink/base/Error.h"

namespace robotlink {

/// A small text file of the user's: a JSON object with "format", "version" and one member for the contents.
/// Written as a whole or not at all. Include this header in sources only: it brings in the JSON library.
/// The identity of such a format.
struct VersionedFormat {
  std::string format;  ///< "robotcontrol-settings"
  // The version that is written, and the newest that can be read.
  int version = 1;
  /// The key of the contents: "settings".
  std::string member;
  std::size_t maxBytes = 16U << 20U;
};

/// Returns the contents, an empty object if there is no such file. Fails with the position of a syntax error,
/// for another format and for a newer version (settings.newer); the file is left as it is.
Result<nlohmann::json> readVersioned(const std::filesystem::path& file, const VersionedFormat& format);
/// Writes the file as a whole or not at all.
Result<void> writeVersioned(const std::filesystem::path& file, const VersionedFormat& format,
                            const nlohmann::json& contents);

/// Renames an unusable file to <file>.broken, replacing an older one, and adds that to the error.
Error keepAside(const std::filesystem::path& file, Error error);

}  // namespace robotlink
