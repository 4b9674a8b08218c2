// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>

#include "robotlink/base/Error.h"
#include "robotlink/base/UnfinishedFile.h"

namespace logplayer {

/// A new folder for files of this program alone, removed with all that is in it when this is destroyed.
class TemporaryFolder {
 public:
  static robotlink::Result<TemporaryFolder> make();
  TemporaryFolder(TemporaryFolder&& other) noexcept
      : path_(std::exchange(other.path_, {})), unfinished_(std::move(other.unfinished_)) {}
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)), unfinished_(path_) {}
  std::filesystem::path path_;
  robotlink::UnfinishedFile unfinished_;  // a signal leaves nothing of it, either
};

}  // namespace logplayer
