// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "robotlink/base/Error.h"

namespace logplayer {

/// What became of the messages of an imported file.
struct ImportReport {
  std::string format;  ///< "B-Human message queue"
  std::uint64_t messages = 0;
  std::map<std::string, std::uint64_t> imported;       ///< by kind: "JPEGImage"
  std::map<std::string, std::uint64_t> notUnderstood;  ///< by kind, "id 123" where it has no name
  std::string damage;                                  ///< with the offset; empty if the file is whole
};

/// Whether a file is of an older format that importLog() reads, by its contents.
bool canImport(const std::filesystem::path& file);

struct ImportOptions {
  std::string robot = "nao";
  /// A .c64 colour table that goes into the log as the one in force; empty: none.
  std::filesystem::path colorTable;
  std::function<bool(double)> progress;
};

/// Converts a log of an older format into a new MCAP file, which must not exist. Given up by progress, nothing
/// is left.
robotlink::Result<ImportReport> importLog(const std::filesystem::path& from, const std::filesystem::path& to,
                                          const ImportOptions& options);

}  // namespace logplayer
