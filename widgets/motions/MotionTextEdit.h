// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/text/MarkedTextEdit.h"

namespace widgets {

class MotionBench;

/// The text of the motion that is edited. Words with errors are underlined, and say by a tooltip what is
/// wrong; comments and keywords have colors. Undo and redo are those of the bench, whose selected line is
/// that of the cursor. GUI thread; the bench must outlive it.
class MotionTextEdit final : public MarkedTextEdit {
  Q_OBJECT
 public:
  explicit MotionTextEdit(MotionBench& bench, QWidget* parent = nullptr);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Takes over what was typed.
  void takeText();
  /// Shows the bench's text, if it is another one.
  void showText();
  void showLine();
  /// Goes to where the editor before this one was.
  void showPlace();
  void underline();
  /// The characters of an error: its word, or the whole line if it has no column.
  QTextCursor wordOf(int line, int column) const;

  MotionBench& bench_;
  /// Whether the text is being replaced by that of the bench.
  bool isShowing_ = false;
};

}  // namespace widgets
