// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "logplayer/LogFile.h"
#include "logplayer/LogImport.h"
#include "logplayer/TemporaryFolder.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// A log as an MCAP file: itself, or of an older format a converted copy, which is removed when this is
/// destroyed.
class ContainerFile {
 public:
  /// Fails if a file of an older format cannot be converted; any other file is taken as it is.
  static robotlink::Result<ContainerFile> of(const std::filesystem::path& log,
                                             const LogFile::Progress& progress);

  const std::filesystem::path& path() const { return path_; }
  /// How it was converted; nothing if it was not.
  const std::optional<ImportReport>& conversion() const { return conversion_; }

 private:
  ContainerFile() = default;

  std::filesystem::path path_;
  std::unique_ptr<TemporaryFolder> folder_;
  std::optional<ImportReport> conversion_;
};

}  // namespace logplayer
