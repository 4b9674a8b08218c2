// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"
#include "widgets/color/ColorFrame.h"

namespace widgets {

/// Reads pictures from files and folders in a thread of its own. Called by one thread. The destructor cancels
/// and waits for at most one picture.
class PictureReading {
 public:
  /// The result.
  struct Read {
    std::vector<ColorFramePtr> frames;
    /// The files that could not be read, and were skipped.
    robotlink::Errors problems;
    /// Number of pictures skipped because the memory bound was reached.
    std::size_t leftOut = 0;
  };
  /// Begins at once. `camera`: name of the robot whose corrections apply. `mostBytes`: bound of the pixels of
  /// all pictures; the one that crosses it is still read.
  PictureReading(std::vector<std::filesystem::path> filesOrFolders, std::string camera,
                 std::size_t mostBytes);

  /// 0 to 1.
  /// The result, once, when everything is read; an error if nothing could be read.
  std::optional<robotlink::Result<Read>> take() { return worker_.take(); }

 private:
  robotlink::Result<Read> readAll(const std::vector<std::filesystem::path>& filesOrFolders,
                                  const std::stop_token& stop);

  const std::string camera_;
  const std::size_t mostBytes_;
  /// Written by the thread.
  /// Its job: files or folders.
  robotlink::Worker<std::vector<std::filesystem::path>, robotlink::Result<Read>> worker_;
};

}  // namespace widgets
