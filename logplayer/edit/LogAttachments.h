// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace logplayer {

// Files attached to a log (MCAP attachments): configurations, notes, pictures.

/// The entry of an attachment in the index of a log. Names are unique in a log that attach() wrote.
struct AttachmentInfo {
  std::string name;
  /// MIME type.
  std::string mediaType;
  /// Size of the data.
  std::uint64_t bytes = 0;
};

/// Lists the attachments in the order of the file. Logs of older formats have none.
robotlink::Result<std::vector<AttachmentInfo>> attachmentsOf(const std::filesystem::path& log);

/// How a file is attached.
struct AttachmentOptions {
  /// Empty: the name of the file.
  std::string name;
  /// Empty: determined by the extension of the file, else application/octet-stream.
  std::string mediaType;
};
/// Appends a file to a log without rewriting it. Fails if the log is incomplete, not writable, not MCAP, or
/// already has an attachment of this name.
robotlink::Result<void> attach(const std::filesystem::path& log, const std::filesystem::path& file,
                               const AttachmentOptions& options);

/// Writes an attachment into a file atomically; fails if the file exists and `overwrite` is false.
robotlink::Result<void> extractAttachment(const std::filesystem::path& log, const std::string& name,
                                          const std::filesystem::path& to, bool overwrite);

}  // namespace logplayer
