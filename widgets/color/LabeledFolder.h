// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"
#include "widgets/color/ColorScorer.h"

namespace widgets {

/// Reads a folder of labeled images (PNG, JPEG, .yuyv) in a thread of its own. The label of an image is a
/// gray PNG of the same size and base name, in a folder "labels" inside of this one or next to it, or in this
/// one. Its values are class numbers, or Evaluation::kIgnored where the class is unknown. The classes' names
/// are read from "labels.classes" in the folder of the labels; without it they are those of the preset
/// bhuman2009. Images may be in subfolders; instead of the images' folder that of the labels can be given.
/// Images without a label are skipped.
///
/// Called by one thread. The destructor cancels and waits for at most one image.
class LabeledFolder {
 public:
  /// The result.
  struct Read {
    std::vector<LabeledFrame> frames;
    /// The files that could not be read, and were skipped.
    robotlink::Errors problems;
  };
  /// Begins at once. `camera`: name of the robot whose corrections apply to the images; empty: none.
  LabeledFolder(std::filesystem::path folder, std::string camera);

  /// 0 to 1.
  double progress() const { return progress_; }
  /// The result, once, when everything is read; an error if nothing could be read.
  std::optional<robotlink::Result<Read>> take() { return worker_.take(); }

 private:
  robotlink::Result<Read> readAll(const std::filesystem::path& chosen, const std::stop_token& stop);

  const std::string camera_;
  /// Written by the thread.
  std::atomic<double> progress_{0};
  /// Its job: the folder.
  robotlink::Worker<std::filesystem::path, robotlink::Result<Read>> worker_;
};

}  // namespace widgets
