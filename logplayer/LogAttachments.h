// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace logplayer {

// Files that are attached to a log (MCAP attachments): configurations, notes, pictures.

struct AttachmentInfo {
  std::string name;
  std::string mediaType;
  std::uint64_t bytes = 0;
};

/// In the order of the file. Logs of older formats have none.
robotlink::Result<std::vector<AttachmentInfo>> attachmentsOf(const std::filesystem::path& log);

struct AttachmentOptions {
  std::string name;       ///< empty: the file's
  std::string mediaType;  ///< empty: by the file's ending, else application/octet-stream
};
/// Appends a file to a log without rewriting it. Fails if the log is not complete, not writable, not MCAP, or
/// has an attachment of this name already.
robotlink::Result<void> attach(const std::filesystem::path& log, const std::filesystem::path& file,
                               const AttachmentOptions& options);

/// Writes an attachment into a file, as a whole or not at all.
robotlink::Result<void> extractAttachment(const std::filesystem::path& log, const std::string& name,
                                          const std::filesystem::path& to, bool overwrite);

}  // namespace logplayer
