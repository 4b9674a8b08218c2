// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "colortool/scoring/BackgroundColors.h"
#include "colortool/scoring/CrossValidation.h"
#include "colortool/table/ColorTable.h"
#include "robotlink/base/Worker.h"
#include "widgets/color/ColorFrame.h"

namespace widgets {

/// An image whose pixels' true classes are known.
struct LabeledFrame {
  ColorFramePtr frame;
  /// The label of each pixel: an index into `classNames`, or Evaluation::kIgnored.
  std::vector<std::uint8_t> labels;
  /// [0] stands for no class.
  std::vector<std::string> classNames;
};

/// The score of a table.
struct ColorQuality {
  /// Number of its task.
  std::uint64_t task = 0;
  /// The classes of the samples, by which all figures are numbered.
  colortool::ColorClasses classes;
  /// Cross-validation: how well the strokes predict each other; unset without strokes.
  std::optional<colortool::StrokeQuality> strokes;
  /// Over the labeled images; unset without such images.
  std::optional<colortool::Evaluation> labeled;
  /// The evaluations of the reference table: over all strokes, and over the labeled images; unset without a
  /// reference.
  std::optional<colortool::Evaluation> referenceStrokes, referenceLabeled;
  /// Score over unlabeled images: numbers of pixels that are suspicious (colortool::SuspicionMeter, without
  /// those that are merely ambiguous), since a label is not needed to see that a color of a thing is wrong
  /// there.
  struct Others {
    /// Number of images, and of their pixels.
    int images = 0;
    std::uint64_t pixels = 0;
    /// Suspicious pixels by class.
    std::vector<std::uint64_t> suspicious;
    /// The share of the background's colors there that the classes take.
    colortool::BackgroundColors::Counts background;
    /// Whether the images are spread over a log, rather than those that the user has seen.
    bool ofLog = false;
  };
  Others others;
};

/// Scores tables in a thread of its own with low priority, since that takes longer than training them and
/// must not delay the picture. Latest wins: a new task cancels the one in progress. Called by one thread. The
/// destructor waits for at most one step of the task in progress.
class ColorScorer {
 public:
  /// A table and what it is scored with.
  struct Task {
    std::uint64_t number = 0;
    colortool::Samples samples;
    /// Trained from `samples`.
    std::shared_ptr<const colortool::ColorTable> table;
    std::shared_ptr<const std::vector<LabeledFrame>> labeled;
    /// Numbered by the samples' classes; null: none.
    std::shared_ptr<const colortool::ColorTable> reference;
    /// Unlabeled images in which suspicious pixels and colors of the background are counted.
    std::vector<ColorFramePtr> others;
    bool othersOfLog = false;
  };
  /// `news` is called in the scorer's thread whenever there is a score to take; it must not block.
  explicit ColorScorer(std::function<void()> news);

  /// Replaces the task.
  void ask(Task task) { worker_.post(std::move(task)); }
  /// The newest score that was not taken yet.
  std::optional<ColorQuality> take() { return worker_.take(); }
  /// Whether the task is done and its score was taken.
  bool idle() const { return worker_.idle(); }

 private:
  robotlink::Worker<Task, ColorQuality> worker_;
};

}  // namespace widgets
