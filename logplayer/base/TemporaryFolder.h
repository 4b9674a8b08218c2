// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>

#include "robotlink/base/Error.h"
#include "robotlink/base/UnfinishedFile.h"

namespace logplayer {

/// A new, empty folder that only this user can access, removed with all its contents by the destructor, or
/// when a signal ends the program. Movable.
class TemporaryFolder {
 public:
  /// Creates the folder in the system's folder for temporary files (TMPDIR); fails if that is impossible.
  static robotlink::Result<TemporaryFolder> make();
  /// The other object no longer owns the folder.
  TemporaryFolder(TemporaryFolder&& other) noexcept
      : path_(std::exchange(other.path_, {})), unfinished_(std::move(other.unfinished_)) {}
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  /// Empty after a move.
  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)), unfinished_(path_) {}
  std::filesystem::path path_;
  /// Removes the folder if a signal ends the program.
  robotlink::UnfinishedFile unfinished_;
};

}  // namespace logplayer
