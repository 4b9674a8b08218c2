// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSyntaxHighlighter>

class QPlainTextEdit;

namespace widgets {

/// The colors of tags, attributes, values and comments of the XML in an editor, after its palette; of the
/// document that is set by setDocument(). A child of the editor. GUI thread.
class XmlColors final : public QSyntaxHighlighter {
  Q_OBJECT
 public:
  explicit XmlColors(QPlainTextEdit& edit);

 protected:
  void highlightBlock(const QString& text) override;

 private:
  /// The state at the beginning or end of a line. The numbers are states of blocks.
  enum State { kText = 0, kComment, kTag, kSingleQuoted, kDoubleQuoted };
  /// Colors what begins at `at` in a state; returns where it ends, and changes the state.
  int color(const QString& text, int at, State& state);
  int colorTag(const QString& text, int at, State& state);

  QPlainTextEdit& edit_;
};

}  // namespace widgets
