// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "colortool/samples/Samples.h"
#include "robotlink/base/Image.h"
#include "robotlink/base/Worker.h"
#include "widgets/color/ColorFrame.h"
#include "widgets/color/ColorScorer.h"

namespace widgets {

/// The input of the learner. Cheap to copy.
struct ColorTask {
  /// Larger than that of all tasks before.
  std::uint64_t number = 0;
  /// The samples from which the table is trained.
  colortool::Samples samples;
  /// The image to segment; null: none.
  ColorFramePtr frame;
  /// The labeled images with which the table is scored, see ColorScorer::Task.
  std::shared_ptr<const std::vector<LabeledFrame>> labeled = {};
  std::shared_ptr<const colortool::ColorTable> reference = {};
  std::vector<ColorFramePtr> others = {};
  bool othersOfLog = false;
};

/// A trained table and the segmentation of an image with it. Immutable.
struct LearnedColors {
  /// Number of its task.
  std::uint64_t task = 0;
  /// The samples from which the table was trained.
  colortool::Samples samples;
  std::shared_ptr<const colortool::ColorTable> table;
  ColorFramePtr frame;
  /// The frame's image with its camera's correction (Samples::correctionOf()); null: there is none.
  std::shared_ptr<const robotlink::Image> corrected;
  /// The class of each pixel of the frame, kMono8; null without a frame.
  std::shared_ptr<const robotlink::Image> classes;
  /// Keyed by ColorTable::cellOf, see TableTrainer::margins(). Null at first; a second result with margins
  /// follows shortly.
  std::shared_ptr<const std::vector<std::uint8_t>> margins;

  /// The frame's image as the table sees it; empty without a frame.
  robotlink::ImageView seen() const {
    return corrected ? corrected->view() : frame ? frame->view() : robotlink::ImageView();
  }
};

/// Trains color tables and segments images with them in a thread of its own: first the table and the image
/// that is seen, then the margins. The table is scored at the same time by a ColorScorer. Latest wins: a task
/// replaces one that has not begun.
///
/// All functions are called by one thread, except `news`. The destructor waits for the step in progress.
class ColorLearner {
 public:
  /// `news` is called in the threads of learner and scorer whenever a result can be taken; it must not block.
  explicit ColorLearner(std::function<void()> news);
  ~ColorLearner();
  ColorLearner(const ColorLearner&) = delete;
  ColorLearner& operator=(const ColorLearner&) = delete;

  /// Replaces a task that has not begun.
  void ask(ColorTask task) { worker_.post(std::move(task)); }
  /// The newest result that was not taken yet.
  std::optional<LearnedColors> takeColors() { return worker_.take(); }
  /// The newest score that was not taken yet.
  std::optional<ColorQuality> takeQuality() { return scorer_.take(); }
  /// Whether all tasks are done and all results were taken.
  bool idle() const { return worker_.idle() && scorer_.idle(); }

 private:
  void learn(const ColorTask& task, const std::stop_token& stop);
  /// Gives the table to the scorer if anything has changed for it.
  void askForScore(const ColorTask& task);

  ColorScorer scorer_;
  /// State of the thread: trainer, last table, what was scored last.
  struct Work;
  std::unique_ptr<Work> work_;
  /// Last, since it uses the other members.
  robotlink::Worker<ColorTask, LearnedColors> worker_;
};

}  // namespace widgets
