// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "robotlink/base/Error.h"
#include "robotlink/base/UnfinishedFile.h"

namespace logplayer {

/// A file that appears under its name only when it is complete: it is written under the name temporary() in
/// the same folder and renamed by commit(). Without commit() the destructor removes it, as does a signal that
/// ends the program. Movable, not copyable.
class OutputFile {
 public:
  /// Fails if the file exists and may not be overwritten, or if its folder does not exist or is not writable.
  /// A symbolic link is kept: the file to which it points is overwritten.
  static robotlink::Result<OutputFile> create(const std::filesystem::path& file, bool overwrite);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  /// The path to write to; no such file exists after create().
  const std::filesystem::path& temporary() const { return temporary_; }
  /// Renames the file. A file that got the name in the meantime is overwritten only if that is allowed.
  robotlink::Result<void> commit();
  /// Replaces the temporary name in an error of the writer by the real name, since the user does not know the
  /// former.
  robotlink::Error named(robotlink::Error error) const;

 private:
  OutputFile() = default;

  /// The name as passed to create().
  std::filesystem::path given_;
  /// The target, with links resolved, and the temporary file; empty after commit() or a move.
  std::filesystem::path file_, temporary_;
  bool overwrite_ = false;
  /// Removes the file if a signal ends the program.
  std::optional<robotlink::UnfinishedFile> unfinished_;
};

}  // namespace logplayer
