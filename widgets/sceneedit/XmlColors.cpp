// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/XmlColors.h"

#include <QPlainTextEdit>

#include "widgets/Theme.h"

namespace widgets {
namespace {

const QString kCommentBegin = QStringLiteral("<!--"), kCommentEnd = QStringLiteral("-->");

bool isXmlWord(QChar c) {
  return c.isLetterOrNumber() || QStringLiteral("_-:.").contains(c);
}

}  // namespace

XmlColors::XmlColors(QPlainTextEdit& edit) : QSyntaxHighlighter(static_cast<QObject*>(&edit)), edit_(edit) {}

void XmlColors::highlightBlock(const QString& text) {
  State state = previousBlockState() > kText ? static_cast<State>(previousBlockState()) : kText;
  for (int at = 0; at < text.size();) at = color(text, at, state);
  setCurrentBlockState(state);
}

int XmlColors::color(const QString& text, int at, State& state) {
  if (state == kText) {
    const int begin = text.indexOf(QLatin1Char('<'), at);
    if (begin < 0) return text.size();
    state = text.midRef(begin).startsWith(kCommentBegin) ? kComment : kTag;
    at = begin;
  }
  if (state == kTag) return colorTag(text, at, state);
  const bool isComment = state == kComment;
  const QString close = isComment                ? kCommentEnd
                        : state == kSingleQuoted ? QStringLiteral("'")
                                                 : QStringLiteral("\"");
  const int found = text.indexOf(close, at);
  const int end = found < 0 ? text.size() : found + close.size();
  setFormat(at, end - at, colorOf(isComment ? Meaning::kMuted : Meaning::kGood, edit_.palette()));
  if (found >= 0) state = isComment ? kText : kTag;
  return end;
}

int XmlColors::colorTag(const QString& text, int at, State& state) {
  QTextCharFormat name;
  name.setForeground(colorOf(Meaning::kNote, edit_.palette()));
  name.setFontWeight(QFont::Bold);
  while (at < text.size()) {
    const QChar c = text[at];
    if (c == QLatin1Char('<')) {
      int end = at + 1;
      while (end < text.size() && (isXmlWord(text[end]) || QStringLiteral("/?!").contains(text[end]))) ++end;
      setFormat(at, end - at, name);
      at = end;
    } else if (c == QLatin1Char('"') || c == QLatin1Char('\'')) {
      // The quote itself has the color of the value.
      setFormat(at, 1, colorOf(Meaning::kGood, edit_.palette()));
      state = c == QLatin1Char('"') ? kDoubleQuoted : kSingleQuoted;
      return at + 1;
    } else if (c == QLatin1Char('>')) {
      const bool isEmpty = at > 0 && text[at - 1] == QLatin1Char('/');
      setFormat(isEmpty ? at - 1 : at, isEmpty ? 2 : 1, name);
      state = kText;
      return at + 1;
    } else {
      if (isXmlWord(c)) setFormat(at, 1, colorOf(Meaning::kNote, edit_.palette()));
      ++at;
    }
  }
  return at;
}

}  // namespace widgets
