// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "robotlink/base/Error.h"

namespace robotlink {

/// A small text file that a user keeps: a JSON object with "format", "version" and one member of contents.
/// Written whole or not at all. For sources, not for headers of others.
struct VersionedFormat {
  std::string format;  ///< "robotcontrol-settings"
  int version = 1;
  std::string member;  ///< where the contents are: "settings"
  std::size_t maxBytes = 16U << 20U;
};

/// The contents; an empty object if there is no such file. Fails with the place of a syntax error, for
/// another format and for a newer version (settings.newer); the file stays as it is.
Result<nlohmann::json> readVersioned(const std::filesystem::path& file, const VersionedFormat& format);
Result<void> writeVersioned(const std::filesystem::path& file, const VersionedFormat& format,
                            const nlohmann::json& contents);

/// Renames a file that cannot be used to <file>.broken, over an older one, and says so in the error.
Error keepAside(const std::filesystem::path& file, Error error);

}  // namespace robotlink
