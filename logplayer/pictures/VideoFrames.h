// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "logplayer/pictures/FrameSource.h"

namespace logplayer {

class VideoReader;

/// Whether a file is a video of a kind that can be read (MP4, QuickTime, AVI, Matroska, WebM, MPEG), judged
/// by its first bytes.
bool isVideo(const std::filesystem::path& file);

/// The frames of a video file, as JPEG images.
class VideoFrames final : public FrameSource {
 public:
  /// Fails if the file cannot be decoded, or if this installation cannot read videos.
  static robotlink::Result<VideoFrames> open(const std::filesystem::path& file);
  VideoFrames(VideoFrames&&) noexcept;
  ~VideoFrames() override;

  std::string format() const override { return "video"; }
  robotlink::Result<std::optional<Frame>> next() override;
  double share() const override;

 private:
  VideoFrames(std::filesystem::path file, std::unique_ptr<VideoReader> reader);

  std::filesystem::path file_;
  std::unique_ptr<VideoReader> reader_;
  /// The number of frames that were read.
  std::uint64_t count_ = 0;
  bool ended_ = false;
};

}  // namespace logplayer
