// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "colortool/ColorTable.h"
#include "colortool/CrossValidation.h"
#include "widgets/color/ColorFrame.h"

namespace widgets {

/// An image whose pixels' classes are known.
struct LabelledFrame {
  ColorFramePtr frame;
  std::vector<std::uint8_t> labels;     ///< a pixel each: index of `classNames`, or Evaluation::kIgnored
  std::vector<std::string> classNames;  ///< [0] is none
};

/// How good a table is.
struct ColorQuality {
  std::uint64_t task = 0;
  colortool::ColorClasses classes;
  /// How well its strokes predict each other; none without strokes.
  std::optional<colortool::StrokeQuality> strokes;
  /// Over images whose classes are known; none without such images.
  std::optional<colortool::Evaluation> labelled;
  /// The same of the table that it is compared with, if there is one: over all strokes, and over the images.
  std::optional<colortool::Evaluation> referenceStrokes, referenceLabelled;
  /// In other images, where no label is needed to see that a color of a thing is wrong: how many pixels of
  /// which class are suspicious (colortool::SuspicionMeter, without what is merely ambiguous), of how many in
  /// all.
  struct Others {
    int images = 0;
    std::uint64_t pixels = 0;
    std::vector<std::uint64_t> suspicious;  ///< by class
  };
  Others others;
};

/// Scores tables in a thread of its own, since that takes longer than to make them, and must not hold up the
/// picture. Only the newest task counts; one that is being worked on is given up for it. One thread calls it.
/// The destructor waits for at most one step of the work in hand.
class ColorScorer {
 public:
  struct Task {
    std::uint64_t number = 0;
    colortool::Samples samples;
    std::shared_ptr<const colortool::ColorTable> table;  ///< that of the samples
    std::shared_ptr<const std::vector<LabelledFrame>> labelled;
    std::shared_ptr<const colortool::ColorTable> reference;  ///< of the samples' classes; null: none
    std::vector<ColorFramePtr> others;                       ///< images to look for what is suspicious in
  };
  /// `news` is called in the scorer's thread whenever there is something to take; it must not block.
  explicit ColorScorer(std::function<void()> news);
  ~ColorScorer();
  ColorScorer(const ColorScorer&) = delete;
  ColorScorer& operator=(const ColorScorer&) = delete;

  void ask(Task task);
  /// The newest that was not yet taken.
  std::optional<ColorQuality> take();
  bool idle() const;

 private:
  void run();
  std::optional<ColorQuality> score(const Task& task) const;
  /// False: it was given up.
  bool scoreImages(const Task& task, ColorQuality& quality) const;
  bool goOn() const;

  const std::function<void()> news_;
  mutable std::mutex mutex_;  // protects what follows but the thread
  std::condition_variable wakeUp_;
  std::optional<Task> task_;
  std::optional<ColorQuality> quality_;
  bool busy_ = false;
  bool quit_ = false;
  std::thread thread_;
};

}  // namespace widgets
