// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "logplayer/base/OutputFile.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/UnfinishedFile.h"

namespace logplayer {

class VideoWriter;

/// A video file that is being written: .avi (Motion JPEG) or .mp4 (H.264). It appears under its name when it
/// is complete, and replaces a file that had the name; without finish() nothing is left of it. One thread.
class VideoOutput {
 public:
  /// Limits of the size, pixels, and of the rate, frames a second.
  static constexpr int kMinSide = 16, kMaxSide = 8192;
  static constexpr double kMinRate = 0.1, kMaxRate = 240;
  /// Less free space than this, in bytes, counts as a full disk: encoders do not report it.
  static constexpr std::uintmax_t kMinFree = 16U << 20U;

  struct Options {
    /// Pixels; odd numbers are rounded down by evenSize().
    int width = 0, height = 0;
    /// Frames a second.
    double rate = 25;
    /// Returns the free bytes of a folder; empty: asks the operating system. Tests replace it.
    std::function<std::uintmax_t(const std::filesystem::path& folder)> freeSpace = {};
  };

  /// Fails if the suffix names no kind of video that can be written (says which can), if size or rate is out
  /// of range, if the folder is missing or not writable, or if there is no encoder.
  static robotlink::Result<VideoOutput> create(const std::filesystem::path& file, const Options& options);
  VideoOutput(VideoOutput&&) noexcept;
  ~VideoOutput();

  /// Encoders need even numbers of pixels.
  static int evenSize(int side) { return side & ~1; }
  /// Checks the suffix only, to fail before anything is done.
  static robotlink::Result<void> checkName(const std::filesystem::path& file);

  /// Appends a frame of the video's (even) size: bytes B G R, top row first, `step` bytes from row to row.
  /// Fails if the disk is full.
  robotlink::Result<void> write(const std::uint8_t* data, int step);
  /// Completes the file. Fails if it cannot be read back, since the disk became full at the end.
  robotlink::Result<void> finish();

 private:
  VideoOutput(OutputFile output, std::filesystem::path file, Options options);
  robotlink::Result<void> checkSpace() const;

  /// The file that was passed to create().
  std::filesystem::path file_;
  Options options_;
  OutputFile output_;
  /// The file being written: the temporary name, with the suffix by which encoders choose the kind of file.
  std::filesystem::path encoded_;
  /// Removes it if a signal ends the program.
  std::optional<robotlink::UnfinishedFile> unfinished_;
  std::unique_ptr<VideoWriter> writer_;
  std::uint64_t frames_ = 0;
};

}  // namespace logplayer
