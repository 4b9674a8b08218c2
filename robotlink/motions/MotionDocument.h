// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/motions/MotionReader.h"

namespace robotlink {

/// The text of a motion that is being edited, what can be read of it, and an unlimited undo history: each
/// change is a step that undo() and redo() reverse exactly. A step stores only the part of the text that it
/// changed. One thread.
class MotionDocument {
 public:
  explicit MotionDocument(std::string text = {}, std::string path = {});

  const std::string& text() const { return text_; }
  /// Returns the readable part of the text; lines with errors are missing.
  const MotionFile& motion() const { return parse_.motion; }
  /// All errors of the text, in its order.
  const Errors& errors() const { return parse_.errors; }
  /// Names the file in errors.
  void setPath(std::string path);
  /// The robot's joints, which are the columns of a text that names none.
  void setJoints(std::vector<std::string> joints);
  const std::vector<std::string>& joints() const { return joints_; }

  /// Adds a step from text() to `next`; without a difference nothing happens. Discards the steps that were
  /// undone. If the previous step has the same nonempty `gesture`, the two become one step: typing, a border
  /// that is dragged. Returns whether there is a new step.
  bool change(std::string what, std::string next, std::string gesture = {});

  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ < steps_.size(); }
  /// Undo and redo also end the current gesture; they do nothing if there is no step.
  void undo();
  void redo();
  /// The number of steps that are applied.
  std::size_t position() const { return position_; }
  /// The number of steps, undone ones included.
  std::size_t steps() const { return steps_.size(); }
  /// The description of a step for the user.
  const std::string& what(std::size_t step) const { return steps_[step].what; }

  /// Whether the text differs from that at the last setSaved(), or from the initial one.
  bool changed() const { return savedPosition_ != position_; }
  /// Marks the current state as saved and ends the current gesture.
  void setSaved();
  /// Ends the current gesture: the next change is a step of its own.
  void endGesture() { gestureEnded_ = true; }

 private:
  /// A replacement of a part of the text.
  struct Step {
    std::string what, gesture;
    std::size_t at = 0;
    std::string before, after;
  };
  static Step difference(const std::string& before, const std::string& after);
  bool continues(const std::string& gesture) const;
  void parse();

  std::string text_;
  std::string path_;
  std::vector<std::string> joints_;
  MotionParse parse_;
  std::vector<Step> steps_;
  /// Steps before this index are applied, the others were undone.
  std::size_t position_ = 0;
  /// Position at the last save; empty if that step was discarded.
  std::optional<std::size_t> savedPosition_ = 0;
  /// Whether the next change starts a new step even if its gesture is that of the last one.
  bool gestureEnded_ = true;
};

}  // namespace robotlink
