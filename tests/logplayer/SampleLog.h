// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "robotlink/base/Clock.h"
#include "tests/TestFolder.h"

namespace logplayer {

using ::TestFolder;

/// A log as a recorder writes it. Frame i of the process "cognition" is at i times 40 ms; each has a camera
/// image (4x2, its first grey value is i), a ball model (at x = i) and every tenth a text "frame <i>", of
/// level warning. The table of debug keys is told with frame 0 and frame 50 (with key "before", then
/// "after"), outside of frames; the scene once, at the start; the platform's joints have steps of their own.
struct SampleLog {
  std::string robot = "red1";
  int frames = 100;
  robotlink::Duration start{0};
  bool close = true;          ///< else the file ends as if its writer was killed
  bool cutLastFrame = false;  ///< its FrameInfo is not written
  void write(const std::filesystem::path& file) const;
};

/// What a sample's frame number is at.
inline robotlink::Instant sampleTime(int frame) {
  return robotlink::Instant(frame * std::chrono::milliseconds(40));
}

}  // namespace logplayer
