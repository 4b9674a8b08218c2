// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colortool/Samples.h"

namespace colortool {

/// Samples with an unlimited history: each change is a step that can be undone and redone, exactly. A step
/// holds only what it changed. One thread.
class SampleDocument {
 public:
  explicit SampleDocument(Samples samples = {}) : samples_(std::move(samples)) {}

  const Samples& samples() const { return samples_; }

  /// Makes a step of what `next` has other than samples(); without a difference there is none. Steps that
  /// were undone are forgotten. With a `gesture` that is that of the step before, both become one: a slider
  /// that moves, a stroke that is being drawn. Whether there is a new step.
  bool change(std::string text, Samples next, std::string gesture = {});

  /// Whether the last step is of this gesture, and a change can still become part of it.
  bool continues(const std::string& gesture) const;
  /// What a change that continues a gesture starts from: the samples before its step, or those of now if
  /// `gesture` is no longer going on.
  Samples beforeGesture(const std::string& gesture) const;

  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ < steps_.size(); }
  void undo();
  void redo();
  /// How many steps there are, what they are called ("stroke orange"), and after how many of them this is.
  std::size_t steps() const { return steps_.size(); }
  const std::string& text(std::size_t step) const { return steps_[step].text; }
  std::size_t position() const { return position_; }
  /// The samples after that many steps, 0 to steps(); those that were undone count.
  Samples samplesAt(std::size_t position) const;

  /// Whether this is other than when setSaved() was called last, or at first.
  bool changed() const { return savedPosition_ != position_; }
  void setSaved() {
    savedPosition_ = position_;
    gestureEnded_ = true;
  }

 private:
  /// What is small is kept whole, strokes only where they differ.
  struct Frame {
    ColorClasses classes;
    TrainingSettings settings;
    std::vector<CameraCorrection> corrections;
    std::vector<SampleImage> images;
  };
  struct Step {
    std::string text, gesture;
    Frame before, after;
    std::vector<StrokePtr> removed, added;  // by id; a stroke that was changed is in both
  };
  static Frame frameOf(const Samples& samples);
  static void apply(Samples& samples, const Frame& frame, const std::vector<StrokePtr>& take,
                    const std::vector<StrokePtr>& put);

  Samples samples_;
  std::vector<Step> steps_;
  std::size_t position_ = 0;
  std::optional<std::size_t> savedPosition_ = 0;  // none: that step is gone
  bool gestureEnded_ = true;
};

}  // namespace colortool
