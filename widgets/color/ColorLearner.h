// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "colortool/Samples.h"
#include "robotlink/base/Image.h"
#include "widgets/color/ColorFrame.h"
#include "widgets/color/ColorScorer.h"

namespace widgets {

/// What the learner is asked for. Cheap to copy.
struct ColorTask {
  std::uint64_t number = 0;  ///< larger than those before
  colortool::Samples samples;
  ColorFramePtr frame;  ///< is segmented; null: nothing is
  std::shared_ptr<const std::vector<LabelledFrame>> labelled = {};
  // What the table is scored by, see ColorScorer::Task.
  std::shared_ptr<const colortool::ColorTable> reference = {};
  std::vector<ColorFramePtr> others = {};
};

/// A table, and what it makes of an image. Immutable.
struct LearnedColors {
  std::uint64_t task = 0;
  colortool::Samples samples;  ///< what the table was made of
  std::shared_ptr<const colortool::ColorTable> table;
  ColorFramePtr frame;
  /// The frame with what Samples::correctionOf() does to its camera's colours; null: nothing.
  std::shared_ptr<const robotlink::Image> corrected;
  std::shared_ptr<const robotlink::Image> classes;  ///< of the frame, kMono8; null without a frame
  /// By ColorTable::cellOf, see TableTrainer::margins(). Null until they are known, shortly after the table.
  std::shared_ptr<const std::vector<std::uint8_t>> margins;

  /// The frame's colours as the table sees them; empty without a frame.
  robotlink::ImageView seen() const {
    return corrected ? corrected->view() : frame ? frame->view() : robotlink::ImageView();
  }
};

/// Makes tables of samples and segments images with them, in a thread of its own: at first what is seen, then
/// the margins. How good the table is, a ColorScorer finds out beside it. Only the newest task counts.
/// All but the constructor's function is called by one thread. The destructor waits for the work in hand.
class ColorLearner {
 public:
  /// `news` is called in the learner's thread whenever there is something to take; it must not block.
  explicit ColorLearner(std::function<void()> news);
  ~ColorLearner();
  ColorLearner(const ColorLearner&) = delete;
  ColorLearner& operator=(const ColorLearner&) = delete;

  void ask(ColorTask task);
  /// The newest that was not yet taken.
  std::optional<LearnedColors> takeColors();
  std::optional<ColorQuality> takeQuality();
  /// Whether all that was asked for is done.
  bool idle() const;

 private:
  struct Work;
  void run();
  bool newTask() const;

  const std::function<void()> news_;
  mutable std::mutex mutex_;  // protects what follows but the scorer and the thread
  std::condition_variable wakeUp_;
  std::optional<ColorTask> task_;
  std::optional<LearnedColors> colors_;
  bool busy_ = false;
  bool quit_ = false;
  ColorScorer scorer_;
  std::thread thread_;
};

}  // namespace widgets
