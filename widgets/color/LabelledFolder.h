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
#include "widgets/color/ColorScorer.h"

namespace widgets {

/// Reads a folder of images (PNG, JPEG, .yuyv) with labels, in a thread of its own: a label is a grey PNG of
/// the image's size and of its name but for the ending, in a folder "labels" in this one or beside it, or in
/// this one. Its values are class numbers, Evaluation::kIgnored where nobody knows; the classes' names stand
/// in "labels.classes" beside the labels, else they are those of the preset bhuman2009. Images may be in
/// folders of this one; the folder of the labels does as well as that of the images. What has no label is
/// passed over. The destructor waits for at most one image.
class LabelledFolder {
 public:
  struct Read {
    std::vector<LabelledFrame> frames;
    robotlink::Errors problems;  ///< what could not be read, and is left out
  };
  /// `camera`: whose correction the images get.
  LabelledFolder(std::filesystem::path folder, std::string camera);
  ~LabelledFolder();
  LabelledFolder(const LabelledFolder&) = delete;
  LabelledFolder& operator=(const LabelledFolder&) = delete;

  /// 0 to 1.
  double progress() const { return progress_; }
  /// Once, when all is read; fails if there is nothing that could be.
  std::optional<robotlink::Result<Read>> take();

 private:
  robotlink::Result<Read> readAll();

  const std::filesystem::path folder_;
  const std::string camera_;
  std::atomic<double> progress_{0};
  std::atomic<bool> quit_{false};
  std::mutex mutex_;  // protects read_
  std::optional<robotlink::Result<Read>> read_;
  std::thread thread_;
};

}  // namespace widgets
