// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "logplayer/pictures/FrameSource.h"

namespace logplayer {

/// The pictures of a folder, sorted by name with numbers by their value ("frame-9" before "frame-10"), five
/// per second. PNG and JPEG files are passed on as they are, without decoding them.
class PictureFrames final : public FrameSource {
 public:
  static constexpr robotlink::Duration kPeriod = std::chrono::milliseconds(200);

  /// Fails if there is no picture in the folder, or if it cannot be read.
  static robotlink::Result<PictureFrames> open(const std::filesystem::path& folder);

  std::string format() const override { return "folder of pictures"; }
  robotlink::Result<std::optional<Frame>> next() override;
  double share() const override;

 private:
  explicit PictureFrames(std::vector<std::filesystem::path> files) : files_(std::move(files)) {}

  std::vector<std::filesystem::path> files_;
  std::size_t next_ = 0;
};

/// Whether this is a folder with at least one picture.
bool isPictureFolder(const std::filesystem::path& folder);

}  // namespace logplayer
