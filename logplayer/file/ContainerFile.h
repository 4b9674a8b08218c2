// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "logplayer/base/Progress.h"
#include "logplayer/base/TemporaryFolder.h"
#include "logplayer/file/LogImport.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// A log as an MCAP file: the file itself, or a converted temporary copy if it has an older format. All users
/// of a log share one copy, which is removed with the last of them. Any thread.
class ContainerFile {
 public:
  /// Fails if a file of an older format cannot be converted. Any other file is accepted as it is; the reader
  /// reports what is wrong with it.
  static robotlink::Result<ContainerFile> of(const std::filesystem::path& log, const Progress& progress);

  /// The MCAP file; valid as long as this object or a copy of it exists.
  const std::filesystem::path& path() const { return path_; }
  /// The report of the conversion; null if the file was not converted.
  const ImportReport* conversion() const { return copy_ == nullptr ? nullptr : &copy_->report; }

 private:
  /// A converted copy, shared by all users of the log.
  struct Copy {
    TemporaryFolder folder;
    ImportReport report;
  };
  /// The registry of the copies that are in use.
  class Copies;
  ContainerFile(std::filesystem::path path, std::shared_ptr<const Copy> copy)
      : path_(std::move(path)), copy_(std::move(copy)) {}
  static robotlink::Result<std::shared_ptr<const Copy>> convert(const std::filesystem::path& log,
                                                                const Progress& progress);

  std::filesystem::path path_;
  std::shared_ptr<const Copy> copy_;
};

}  // namespace logplayer
