// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>

#include "logplayer/base/TemporaryFolder.h"

namespace logplayer {

/// A temporary folder that is removed also after its program was killed: the next program that makes one
/// removes those whose programs no longer run, which it knows from a lock that the system holds for each.
class ScratchFolder {
 public:
  /// Fails if the folder cannot be made.
  static robotlink::Result<ScratchFolder> make();
  ScratchFolder(ScratchFolder&& other) noexcept
      : folder_(std::move(other.folder_)), lock_(std::exchange(other.lock_, -1)) {}
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  ScratchFolder(TemporaryFolder folder, int lock) : folder_(std::move(folder)), lock_(lock) {}

  TemporaryFolder folder_;
  /// The descriptor of the locked file.
  int lock_;
};

}  // namespace logplayer
