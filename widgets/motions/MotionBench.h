// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/motions/MotionDocument.h"
#include "robotlink/motions/MotionEdits.h"
#include "widgets/View.h"
#include "widgets/text/TextPlace.h"

namespace robotcontrol {
class MotionTable;
}

namespace widgets {

/// The motion that is being edited, shared by all views of a window: its text with its undo stack (the
/// document), the line that is selected, and its errors for the selected robot, together with the robot's
/// other motions. GUI thread.
///
/// Files are handled by MotionFiles, the robot by MotionLink.
class MotionBench final : public QObject {
  Q_OBJECT
 public:
  /// The context must outlive the bench.
  explicit MotionBench(ViewContext& context, QObject* parent = nullptr);

  ViewContext& context() const { return context_; }
  const robotlink::MotionDocument& document() const { return document_; }
  const robotlink::MotionFile& motion() const { return document_.motion(); }
  /// Whether there is no motion at all: nothing was written.
  bool isEmpty() const { return document_.text().empty(); }
  /// Mirrors the document's history, so that views can use Qt's undo actions.
  QUndoStack& undoStack() { return undo_; }
  /// Makes a step of the document's history, see MotionDocument::change(); every change goes through here.
  void change(const QString& what, std::string next, const std::string& gesture = {});
  /// Replaces the document; its history starts over. `changed`: it has unsaved changes.
  void setDocument(std::string text, const std::string& path, bool changed = false);
  /// The text was saved as it is, to this file.
  void setSaved(const std::string& path);

  /// The line that is selected, from 1: where the cursor of the text is.
  int line() const { return line_; }
  void setLine(int line);
  /// The place of the editor in the text when it was last shown.
  const TextPlace& place() const { return place_; }
  void setPlace(const TextPlace& place) { place_ = place; }
  /// The key frames, and the index of the one in the selected line, or before it; -1: there is none.
  const std::vector<robotlink::KeyFramePlace>& frames() const { return frames_; }
  int frame() const;
  void setFrame(int frame);

  /// The errors of the text: those of its syntax, or, if it can be read, those that the compiler of the
  /// robot's motions reports.
  const robotlink::Errors& errors() const;
  /// The joint of each column; without names, numbers.
  std::vector<std::string> columns() const;

  /// Follows the selected robot and its motions; called 30 times a second.
  void tick();
  const std::string& robot() const { return robot_; }
  /// The description of the selected robot; null: unknown.
  const std::shared_ptr<const robotlink::RobotDescription>& description() const { return description_; }
  /// The motions of the robot's program; null: it has published none.
  const robotcontrol::MotionTable* table() const;
  /// The robot's text of the motion that is edited; empty: it has none of this name. Whether it was sent.
  struct RobotText {
    std::string text;
    bool isSent = false;
  };
  std::optional<RobotText> robotText() const;

  // Edits of the selected key frame, or of all. They fail without one, and say why.
  /// Adds a key frame after the selected one, or at the end, and selects it.
  void addFrame(const QString& what, const robotlink::KeyFrame& frame);
  robotlink::Result<void> duplicateFrame();
  robotlink::Result<void> removeFrame();
  /// Exchanges the key frame with the one `count` places later (negative: earlier).
  robotlink::Result<void> moveFrame(int count);
  robotlink::Result<void> mirror(bool onlyFrame);
  /// Replaces a value by a text of the table or of a command: an angle in the text's units, '*' or '-'.
  robotlink::Result<void> setValue(int frame, int column, const QString& value);
  robotlink::Result<void> setInterpolation(int frame, int interpolation);
  robotlink::Result<void> setDuration(int frame, robotlink::Duration duration,
                                      const std::string& gesture = {});

 Q_SIGNALS:
  /// The text changed, also by undo and redo.
  void changed();
  void lineChanged();
  /// errors() changed although the text did not, or robotText() did.
  void robotChanged();

 private:
  void follow();
  void takeChange();
  /// Compiles the motion together with the others of the robot.
  void compile();
  robotlink::Result<void> requireFrame(int frame) const;
  robotlink::Result<std::vector<robotlink::MirroredJoint>> mirrorOfColumns() const;

  ViewContext& context_;
  robotlink::MotionDocument document_;
  QUndoStack undo_;
  std::vector<robotlink::KeyFramePlace> frames_;
  robotlink::Errors compileErrors_;
  int line_ = 1;
  TextPlace place_;
  std::string robot_;
  std::shared_ptr<const robotlink::RobotDescription> description_;
  /// The address of the table that compile() has seen.
  const void* seenTable_ = nullptr;
  bool isCompileDue_ = true;
};

/// The bench of a window, created on the first call.
MotionBench& motionBench(ViewContext& context);

}  // namespace widgets
