// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colortool/samples/Samples.h"

namespace colortool {

/// Samples with an unlimited undo history: each change is a step that undo() and redo() reverse exactly. A
/// step stores only what it changed. One thread.
class SampleDocument {
 public:
  explicit SampleDocument(Samples samples = {}) : samples_(std::move(samples)) {}

  /// The current samples.
  const Samples& samples() const { return samples_; }

  /// Adds a step from samples() to `next`; without a difference nothing happens. Discards the steps that were
  /// undone. If the previous step has the same nonempty `gesture`, the two become one step: a slider that
  /// moves, a stroke that is being drawn. Returns whether there is a new step.
  bool change(std::string text, Samples next, std::string gesture = {});

  /// Whether the last step belongs to this gesture and a change can still be merged into it.
  bool continues(const std::string& gesture) const;
  /// The samples from which a change that continues a gesture starts: those before its step, or the current
  /// ones if the gesture has ended.
  Samples beforeGesture(const std::string& gesture) const;

  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ < steps_.size(); }
  /// Undo and redo also end the current gesture; they do nothing if there is no step.
  void undo();
  void redo();
  /// The number of steps, undone ones included.
  std::size_t steps() const { return steps_.size(); }
  /// The description of a step for the user: "stroke orange".
  const std::string& text(std::size_t step) const { return steps_[step].text; }
  /// The number of steps that are applied.
  std::size_t position() const { return position_; }
  /// The samples after `position` steps, 0 to steps(), undone ones included. Costs as many undo steps as it
  /// is away.
  Samples samplesAt(std::size_t position) const;

  /// Whether the samples differ from those at the last setSaved(), or from the initial ones.
  bool changed() const { return savedPosition_ != position_; }
  /// Marks the current state as saved and ends the current gesture.
  void setSaved() {
    savedPosition_ = position_;
    gestureEnded_ = true;
  }

 private:
  /// The parts of Samples that are small enough to be stored whole in each step; of the strokes only the
  /// differences are stored.
  struct Frame {
    ColorClasses classes;
    TrainingSettings settings;
    std::vector<CameraCorrection> corrections;
    std::vector<SampleImage> images;
  };
  /// A change of the samples, reversible in both directions.
  struct Step {
    std::string text, gesture;
    Frame before, after;
    /// Sorted by id; a stroke that was changed is in both lists.
    std::vector<StrokePtr> removed, added;
  };
  static Frame frameOf(const Samples& samples);
  /// Replaces the small parts by `frame`, removes the strokes `take` and inserts the strokes `put`.
  static void apply(Samples& samples, const Frame& frame, const std::vector<StrokePtr>& take,
                    const std::vector<StrokePtr>& put);

  Samples samples_;
  std::vector<Step> steps_;
  /// Steps before this index are applied, the others were undone.
  std::size_t position_ = 0;
  /// Position at the last save; empty if that step was discarded.
  std::optional<std::size_t> savedPosition_ = 0;
  /// Whether the next change starts a new step even if its gesture is that of the last one.
  bool gestureEnded_ = true;
};

}  // namespace colortool
