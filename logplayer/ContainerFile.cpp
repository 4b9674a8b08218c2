// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/ContainerFile.h"

namespace logplayer {

robotlink::Result<ContainerFile> ContainerFile::of(const std::filesystem::path& log,
                                                   const LogFile::Progress& progress) {
  ContainerFile result;
  result.path_ = log;
  if (!canImport(log)) return result;
  auto folder = TemporaryFolder::make();
  if (!folder) return tl::unexpected(folder.error());
  result.folder_ = std::make_unique<TemporaryFolder>(std::move(*folder));
  result.path_ = result.folder_->path() / "log.mcap";
  ImportOptions options;
  options.progress = progress;
  auto report = importLog(log, result.path_, options);
  if (!report) return tl::unexpected(report.error());
  result.conversion_ = std::move(*report);
  return result;
}

}  // namespace logplayer
