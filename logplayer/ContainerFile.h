// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "logplayer/LogFile.h"
#include "logplayer/LogImport.h"
#include "logplayer/TemporaryFolder.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// A log as an MCAP file: itself, or of an older format a converted copy. All that use a log at the same time
/// share its copy, which is removed when the last of them is destroyed. Any thread.
class ContainerFile {
 public:
  /// Fails if a file of an older format cannot be converted; any other file is taken as it is.
  static robotlink::Result<ContainerFile> of(const std::filesystem::path& log,
                                             const LogFile::Progress& progress);

  const std::filesystem::path& path() const { return path_; }
  /// How it was converted; null if it was not.
  const ImportReport* conversion() const { return copy_ == nullptr ? nullptr : &copy_->report; }

 private:
  struct Copy {
    TemporaryFolder folder;
    ImportReport report;
  };
  class Copies;
  ContainerFile(std::filesystem::path path, std::shared_ptr<const Copy> copy)
      : path_(std::move(path)), copy_(std::move(copy)) {}
  static robotlink::Result<std::shared_ptr<const Copy>> convert(const std::filesystem::path& log,
                                                                const LogFile::Progress& progress);

  std::filesystem::path path_;
  std::shared_ptr<const Copy> copy_;
};

}  // namespace logplayer
