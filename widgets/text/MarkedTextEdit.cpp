// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/text/MarkedTextEdit.h"

#include <QFontDatabase>
#include <QHelpEvent>
#include <QStringList>
#include <QSyntaxHighlighter>
#include <QToolTip>

namespace widgets {
namespace {

constexpr std::size_t kMaxMarks = 200;

}  // namespace

MarkedTextEdit::MarkedTextEdit(QWidget* parent) : QPlainTextEdit(parent) {
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabChangesFocus(true);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &MarkedTextEdit::showMarks);
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
