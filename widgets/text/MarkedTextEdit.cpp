// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/text/MarkedTextEdit.h"

#include <QFontDatabase>
#include <QHelpEvent>
#include <QScrollBar>
#include <QStringList>
#include <QSyntaxHighlighter>
#include <QToolTip>
#include <algorithm>

namespace widgets {
namespace {

constexpr std::size_t kMaxMarks = 200;

}  // namespace

MarkedTextEdit::MarkedTextEdit(QWidget* parent) : QPlainTextEdit(parent) {
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabChangesFocus(true);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &MarkedTextEdit::showMarks);
  connectPlace();
}

void MarkedTextEdit::connectPlace() {
  const auto note = [this] {
    // Changes in an editor behind others, or in one that is being closed, are not made by the user.
    if (isVisible()) Q_EMIT placeChanged();
  };
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, note);
  connect(this, &QPlainTextEdit::selectionChanged, this, note);
  connect(verticalScrollBar(), &QScrollBar::valueChanged, this, note);
  connect(horizontalScrollBar(), &QScrollBar::valueChanged, this, note);
}

TextPlace MarkedTextEdit::place() const {
  const QTextCursor cursor = textCursor();
  const int top = unscrolled_ ? unscrolled_->top : verticalScrollBar()->value();
  const int left = unscrolled_ ? unscrolled_->left : horizontalScrollBar()->value();
  return {cursor.position(), cursor.anchor(), top, left};
}

void MarkedTextEdit::setPlace(const TextPlace& place) {
  const int last = std::max(0, document()->characterCount() - 1);
  QTextCursor cursor(document());
  cursor.setPosition(std::clamp(place.anchor, 0, last));
  cursor.setPosition(std::clamp(place.position, 0, last), QTextCursor::KeepAnchor);
  unscrolled_ = place;
  setTextCursor(cursor);
  if (isVisible()) scrollToPlace();
}

void MarkedTextEdit::scrollToPlace() {
  if (!unscrolled_) return;
  const TextPlace place = *unscrolled_;
  verticalScrollBar()->setValue(place.top);
  horizontalScrollBar()->setValue(place.left);
  dropPlace();
}

void MarkedTextEdit::showEvent(QShowEvent* event) {
  QPlainTextEdit::showEvent(event);
  scrollToPlace();
}

void MarkedTextEdit::setMarks(std::vector<TextMark> marks) {
  marks_ = std::move(marks);
  if (marks_.size() > kMaxMarks) marks_.resize(kMaxMarks);
  showMarks();
}

void MarkedTextEdit::showMarks() {
  QList<QTextEdit::ExtraSelection> shown;
  QTextEdit::ExtraSelection current;
  current.format.setBackground(
      mixed(palette().color(QPalette::Base), palette().color(QPalette::Highlight), 0.15));
  current.format.setProperty(QTextFormat::FullWidthSelection, true);
  current.cursor = textCursor();
  current.cursor.clearSelection();
  shown << current;
  for (const TextMark& mark : marks_) {
    QTextEdit::ExtraSelection one;
    one.cursor = mark.part;
    one.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    one.format.setUnderlineColor(colorOf(mark.meaning, palette()));
    if (mark.meaning == Meaning::kBad) one.format.setForeground(colorOf(mark.meaning, palette()));
    one.format.setToolTip(mark.text);
    shown << one;
  }
  setExtraSelections(shown);
}

QString MarkedTextEdit::errorAt(const QPoint& place) const {
  const int position = cursorForPosition(place).position();
  QStringList texts;
  for (const TextMark& mark : marks_) {
    if (position >= mark.part.selectionStart() && position <= mark.part.selectionEnd()) texts << mark.text;
  }
  return texts.join(QLatin1Char('\n'));
}

bool MarkedTextEdit::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    auto* help = static_cast<QHelpEvent*>(event);
    const QString tip = tipAt(help->pos());
    if (tip.isEmpty())
      QToolTip::hideText();
    else
      QToolTip::showText(help->globalPos(), tip, this);
    return true;
  }
  return QPlainTextEdit::viewportEvent(event);
}

void MarkedTextEdit::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    if (auto* colors = findChild<QSyntaxHighlighter*>()) colors->rehighlight();
    showMarks();
  }
}

}  // namespace widgets
