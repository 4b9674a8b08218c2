// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "robotlink/base/Clock.h"
#include "tests/TestFolder.h"

namespace logplayer {

using ::TestFolder;

/// A log as written by a recorder. Frame i of the process "cognition" is at i times 40 ms; each has a camera
/// image (4x2, its first gray value is i), a ball model (at x = i) and every tenth a text "frame <i>" of
/// level warning. The table of debug keys is published with frame 0 and frame 50 (with the key "before", then
/// "after"), outside of frames; the scene once, at the start; the joints of the platform have steps of their
/// own.
struct SampleLog {
  std::string robot = "red1";
  int frames = 100;
  robotlink::Duration start{0};
  /// Whether the file is closed; otherwise it ends as after a crash of the writer.
  bool close = true;
  /// Whether the last FrameInfo is missing.
  bool cutLastFrame = false;
  void write(const std::filesystem::path& file) const;
};

/// The time of a frame, if the log starts at 0.
inline robotlink::Instant sampleTime(int frame) {
  return robotlink::Instant(frame * std::chrono::milliseconds(40));
}

}  // namespace logplayer
