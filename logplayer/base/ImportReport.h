// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace logplayer {

/// The result of the import of a file, by kinds of messages.
struct ImportReport {
  /// Name of the format: "B-Human message queue".
  std::string format;
  /// Number of messages in the imported file.
  std::uint64_t messages = 0;
  /// Number of imported messages by kind: "JPEGImage".
  std::map<std::string, std::uint64_t> imported;
  /// Number of messages that were left out, by kind ("id 123" if it has no name).
  std::map<std::string, std::uint64_t> notUnderstood;
  /// The damage of the file, with its offset; empty if the file is intact.
  std::string damage;
};

}  // namespace logplayer
