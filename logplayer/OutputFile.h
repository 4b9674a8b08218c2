// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "robotlink/base/Error.h"
#include "robotlink/base/UnfinishedFile.h"

namespace logplayer {

/// A file in the making: written under the name temporary() beside its place, and given its own name by
/// commit(). Without that nothing is left of it, also if a signal ends the program. Moved, not copied.
class OutputFile {
 public:
  /// Fails if there is such a file already and it may not be overwritten, or if the folder does not exist. A
  /// symbolic link is kept: the file that it points to is overwritten.
  static robotlink::Result<OutputFile> create(const std::filesystem::path& file, bool overwrite);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  /// A name that no file has yet.
  const std::filesystem::path& temporary() const { return temporary_; }
  /// A file that got the name meanwhile is overwritten only if it may be.
  robotlink::Result<void> commit();
  /// An error of whoever wrote temporary(), as one of this file: that name means nothing to people, and is
  /// soon removed.
  robotlink::Error named(robotlink::Error error) const;

 private:
  OutputFile() = default;

  std::filesystem::path given_;             // as it was called
  std::filesystem::path file_, temporary_;  // empty once there is nothing to remove
  bool overwrite_ = false;
  std::optional<robotlink::UnfinishedFile> unfinished_;
};

}  // namespace logplayer
