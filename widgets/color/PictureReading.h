// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "robotlink/base/Error.h"
#include "widgets/color/ColorFrame.h"

namespace widgets {

/// Reads pictures, from files and folders, to be painted in; in a thread of its own. The destructor waits for
/// at most one picture.
class PictureReading {
 public:
  struct Read {
    std::vector<ColorFramePtr> frames;
    robotlink::Errors problems;  ///< what could not be read, and is left out
    std::size_t leftOut = 0;     ///< pictures that there was no memory for
  };
  /// `camera`: whose images they are, for its corrections. `mostBytes`: of all pixels together.
  PictureReading(std::vector<std::filesystem::path> filesOrFolders, std::string camera,
                 std::size_t mostBytes);
  ~PictureReading();
  PictureReading(const PictureReading&) = delete;
  PictureReading& operator=(const PictureReading&) = delete;

  /// 0 to 1.
  double progress() const { return progress_; }
  /// Once, when all is read; fails if there is nothing that could be.
  std::optional<robotlink::Result<Read>> take();

 private:
  robotlink::Result<Read> readAll();

  const std::vector<std::filesystem::path> filesOrFolders_;
  const std::string camera_;
  const std::size_t mostBytes_;
  std::atomic<double> progress_{0};
  std::atomic<bool> quit_{false};
  std::mutex mutex_;  // protects read_
  std::optional<robotlink::Result<Read>> read_;
  std::thread thread_;
};

}  // namespace widgets
