// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/MotionTextEdit.h"

#include <QKeyEvent>
#include <QSyntaxHighlighter>
#include <QTextBlock>
#include <QTextDocument>
#include <algorithm>
#include <utility>
#include <vector>

#include "robotlink/motions/MotionWords.h"
#include "widgets/Controls.h"
#include "widgets/Theme.h"
#include "widgets/motions/MotionBench.h"

namespace widgets {
namespace {

/// Colors of comments and keywords.
class MotionColors final : public QSyntaxHighlighter {
 public:
  explicit MotionColors(QPlainTextEdit& edit) : QSyntaxHighlighter(edit.document()), edit_(edit) {}

 protected:
  void highlightBlock(const QString& text) override {
    const QByteArray row = text.toUtf8();
    const std::string_view view(row.constData(), static_cast<std::size_t>(row.size()));
    const auto words = robotlink::motionWords(view);
    const auto widthOf = [](std::string_view part) {
      return QString::fromUtf8(part.data(), static_cast<int>(part.size())).size();
    };
    const auto comment = robotlink::motionCommentStart(view);
    const int begin = widthOf(view.substr(0, comment));
    setFormat(begin, text.size() - begin, colorOf(Meaning::kMuted, edit_.palette()));
    if (words.empty()) return;
    const std::string_view first = words[0].text;
    const bool isKey = first == "label" || first == "transition" || first == "hardness" ||
                       (words.size() > 1 && words[1].text == "=");
    if (!isKey) return;
    QTextCharFormat format;
    format.setForeground(colorOf(Meaning::kNote, edit_.palette()));
    format.setFontWeight(QFont::Bold);
    setFormat(widthOf(view.substr(0, static_cast<std::size_t>(words[0].column - 1))), widthOf(first), format);
  }

 private:
  QPlainTextEdit& edit_;
};

}  // namespace

MotionTextEdit::MotionTextEdit(MotionBench& bench, QWidget* parent) : MarkedTextEdit(parent), bench_(bench) {
  describe(*this, {"motionText", tr("Text of the motion"), {}});
  setUndoRedoEnabled(false);  // the bench has the history
  new MotionColors(*this);
  showText();
  connect(this, &QPlainTextEdit::textChanged, this, &MotionTextEdit::takeText);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
    if (!isShowing_) bench_.setLine(textCursor().blockNumber() + 1);
  });
  connect(&bench, &MotionBench::changed, this, &MotionTextEdit::showText);
  connect(&bench, &MotionBench::robotChanged, this, &MotionTextEdit::underline);
  connect(&bench, &MotionBench::lineChanged, this, &MotionTextEdit::showLine);
  showPlace();
  connect(this, &MarkedTextEdit::placeChanged, this, [this] { bench_.setPlace(place()); });
}

void MotionTextEdit::showPlace() {
  const TextPlace& before = bench_.place();
  // Another line may have been selected since, or another motion opened.
  if (document()->findBlock(before.position).blockNumber() != bench_.line() - 1) return;
  isShowing_ = true;
  setPlace(before);
  isShowing_ = false;
}

void MotionTextEdit::takeText() {
  if (isShowing_) return;
  // Typing in one line is undone in one step.
  const std::string gesture = "typing " + std::to_string(textCursor().blockNumber());
  bench_.change(tr("Typing"), toPlainText().toStdString(), gesture);
}

void MotionTextEdit::showText() {
  const QString after = QString::fromStdString(bench_.document().text()), before = toPlainText();
  if (after != before) {
    // Only the part that differs is replaced, so that cursor and scroll bars stay.
    const int shorter = std::min(after.size(), before.size());
    int same = 0, sameEnd = 0;
    while (same < shorter && after[same] == before[same]) ++same;
    while (sameEnd < shorter - same &&
           after[after.size() - 1 - sameEnd] == before[before.size() - 1 - sameEnd])
      ++sameEnd;
    isShowing_ = true;
    QTextCursor cursor(document());
    cursor.setPosition(same);
    cursor.setPosition(before.size() - sameEnd, QTextCursor::KeepAnchor);
    cursor.insertText(after.mid(same, after.size() - same - sameEnd));
    isShowing_ = false;
    showLine();
  }
  underline();
}

void MotionTextEdit::showLine() {
  const int line = bench_.line() - 1;
  if (textCursor().blockNumber() == line || line >= blockCount()) return;
  isShowing_ = true;
  dropPlace();
  setTextCursor(QTextCursor(document()->findBlockByNumber(line)));
  isShowing_ = false;
  ensureCursorVisible();
}

QTextCursor MotionTextEdit::wordOf(int line, int column) const {
  const QTextBlock block = document()->findBlockByNumber(std::clamp(line - 1, 0, blockCount() - 1));
  const QByteArray row = block.text().toUtf8();
  const std::string_view view(row.constData(), static_cast<std::size_t>(row.size()));
  // Columns count bytes.
  const auto place = [&](std::size_t byte) {
    return block.position() + QString::fromUtf8(row.constData(), static_cast<int>(byte)).size();
  };
  QTextCursor cursor(block);
  for (const auto& word : robotlink::motionWords(view)) {
    if (word.column != column) continue;
    const auto begin = static_cast<std::size_t>(word.column - 1);
    // An error of the compiler is about the whole line, and says so by the first column.
    const bool isWhole = column == 1 && bench_.document().errors().empty();
    cursor.setPosition(place(begin));
    cursor.setPosition(place(isWhole ? robotlink::motionCommentStart(view) : begin + word.text.size()),
                       QTextCursor::KeepAnchor);
    return cursor;
  }
  cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
  return cursor;
}

void MotionTextEdit::underline() {
  std::vector<TextMark> marks;
  for (const robotlink::Error& error : bench_.errors())
    marks.push_back({wordOf(error.where.line, error.where.column), QString::fromStdString(error.text)});
  setMarks(std::move(marks));
}

void MotionTextEdit::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Undo)) return bench_.undoStack().undo();
  if (event->matches(QKeySequence::Redo)) return bench_.undoStack().redo();
  MarkedTextEdit::keyPressEvent(event);
}

}  // namespace widgets
