// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

// What robotcontrol_video.so offers. It is a module of its own, loaded when the first video is opened,
// because OpenCV's videoio brings more than 200 shared libraries, which every start would have to load.

namespace logplayer {

/// The frames of a video file. One thread.
class VideoReader {
 public:
  struct Frame {
    int width = 0, height = 0;
    /// Bytes from the start of a row to the start of the next.
    int step = 0;
    /// Bytes B G R, top row first; they belong to the reader and are valid until its next call.
    const std::uint8_t* data = nullptr;
    /// Since the first frame, seconds; never decreases.
    double time = 0;
  };

  virtual ~VideoReader() = default;
  /// Decodes the next frame; false at the end, or where the file breaks off.
  virtual bool next(Frame& frame) = 0;
  /// The number of frames that the file states; 0 if it does not.
  virtual std::uint64_t frames() const = 0;
};

/// The module's only function. Returns null if the file cannot be opened as a video; the caller owns the
/// reader.
using OpenVideo = VideoReader* (*)(const char* file);
inline constexpr char kOpenVideo[] = "robotcontrol_open_video";

}  // namespace logplayer
