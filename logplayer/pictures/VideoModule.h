// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

// The interface of robotcontrol_video.so, a separate module that is loaded when the first video is opened or
// written, because OpenCV's videoio brings more than 200 shared libraries, which every start would have to
// load.

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
    /// The time since the first frame, seconds; never decreases.
    double time = 0;
  };

  virtual ~VideoReader() = default;
  /// Decodes the next frame; false at the end, or where the file breaks off.
  virtual bool next(Frame& frame) = 0;
  /// The number of frames that the file states; 0 if it does not.
  virtual std::uint64_t frames() const = 0;
};

/// A video file that is being written; the destructor completes it. One thread.
class VideoWriter {
 public:
  virtual ~VideoWriter() = default;
  /// Appends a frame of the video's size: bytes B G R, top row first, `step` bytes from row to row. False if
  /// it cannot be encoded. A disk that is full is not noticed.
  virtual bool write(const std::uint8_t* data, int step) = 0;
};

/// Opens a video. Returns null if the file cannot be opened as one; the caller owns the reader.
using OpenVideo = VideoReader* (*)(const char* file);
inline constexpr char kOpenVideo[] = "robotcontrol_open_video";

/// Creates a video. Its kind follows from the file's suffix: .avi has Motion JPEG, .mp4 has H.264 or, where
/// that is missing, MPEG-4. `rate` is in frames a second. Returns null if no such encoder is there, or if the
/// file cannot be made; the caller owns the writer.
using CreateVideo = VideoWriter* (*)(const char* file, int width, int height, double rate);
inline constexpr char kCreateVideo[] = "robotcontrol_create_video";

}  // namespace logplayer
