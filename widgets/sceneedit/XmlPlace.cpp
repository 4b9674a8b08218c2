// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/XmlPlace.h"

#include <algorithm>

#include "widgets/sceneedit/XmlText.h"

namespace widgets {
namespace {

/// The names of the open elements, changed by a tag that is passed.
void passTag(QStringList& open, const XmlTag& tag) {
  if (tag.kind == XmlTag::Kind::kOpening) open << tag.name;
  if (tag.kind != XmlTag::Kind::kClosing) return;
  const int matching = open.lastIndexOf(tag.name);
  if (matching >= 0) open.erase(open.begin() + matching, open.end());
}

/// The place in what a tag has before it, behind its name.
void placeInAttributes(const QString& written, int begin, XmlPlace& place) {
  int wordBegin = 0;
  bool isBehindEqual = false;
  QChar quote;
  QString name;
  for (int i = 0; i < written.size(); ++i) {
    const QChar c = written[i];
    if (!quote.isNull()) {
      if (c != quote) continue;
      quote = {};
      isBehindEqual = false;
      wordBegin = i + 1;
    } else if (c == QLatin1Char('"') || c == QLatin1Char('\'')) {
      quote = c;
      wordBegin = i + 1;
    } else if (c == QLatin1Char('=')) {
      name = written.mid(wordBegin, i - wordBegin).trimmed();
      isBehindEqual = true;
    } else if (c.isSpace() || c == QLatin1Char('/')) {
      wordBegin = isBehindEqual ? wordBegin : i + 1;
    }
  }
  place.prefix = written.mid(wordBegin);
  place.prefixBegin = begin + wordBegin;
  place.kind = !quote.isNull() ? XmlPlace::Kind::kAttributeValue
               : isBehindEqual ? XmlPlace::Kind::kElsewhere
                               : XmlPlace::Kind::kAttributeName;
  if (place.kind == XmlPlace::Kind::kAttributeValue) place.attribute = name;
}

void placeInTag(const QString& text, int position, const XmlTag& tag, XmlPlace& place) {
  using Kind = XmlPlace::Kind;
  place.kind = Kind::kElsewhere;
  if (tag.kind == XmlTag::Kind::kOther) return;
  const bool isClosing = tag.kind == XmlTag::Kind::kClosing;
  const int nameBegin = tag.begin + (isClosing ? 2 : 1), nameEnd = nameBegin + tag.name.size();
  place.element = tag.name;
  if (position < nameBegin) return;
  if (position <= nameEnd) {
    place.kind = isClosing ? Kind::kClosingName : Kind::kTagName;
    place.prefix = text.mid(nameBegin, position - nameBegin);
    place.prefixBegin = nameBegin;
    return;
  }
  if (isClosing) return;
  place.attributes = xmlAttributes(text, tag).keys();
  placeInAttributes(text.mid(nameEnd, position - nameEnd), nameEnd, place);
}

/// The blanks with which the line of a position begins.
QString indentOf(const QString& text, int position) {
  const int begin = position > 0 ? text.lastIndexOf(QLatin1Char('\n'), position - 1) + 1 : 0;
  int end = begin;
  while (end < position && (text[end] == QLatin1Char(' ') || text[end] == QLatin1Char('\t'))) ++end;
  return text.mid(begin, end - begin);
}

}  // namespace

XmlPlace xmlPlaceAt(const QString& text, int position) {
  XmlPlace place;
  place.prefixBegin = 0;
  for (const XmlTag& tag : xmlTags(text)) {
    if (tag.begin >= position) break;
    if (position < tag.end || (position == tag.end && !tag.isComplete)) {
      placeInTag(text, position, tag, place);
      return place;
    }
    passTag(place.path, tag);
    place.prefixBegin = tag.end;
  }
  place.prefix = text.mid(place.prefixBegin, position - place.prefixBegin);
  return place;
}

QString closingTagFor(const QString& text, int position) {
  for (const XmlElement& element : xmlElements(text)) {
    if (element.openEnd != position || element.name.isEmpty()) continue;
    return element.isClosed ? QString() : QStringLiteral("</%1>").arg(element.name);
  }
  return {};
}

XmlClosing closingAt(const QString& text, int position) {
  XmlClosing closing;
  const XmlPlace place = xmlPlaceAt(text, position);
  if (place.kind != XmlPlace::Kind::kText || place.path.isEmpty()) return closing;
  closing.name = place.path.last() + QLatin1Char('>');
  int next = position;
  while (next < text.size() && text[next].isSpace()) ++next;
  const QString tag = QStringLiteral("</") + closing.name;
  if (text.midRef(next, tag.size()) != tag) return closing;
  closing.end = next + tag.size();
  const int line = position - indentOf(text, position).size();
  const bool isBlank = line == 0 || text[line - 1] == QLatin1Char('\n');
  if (!isBlank) return closing;
  closing.blankBegin = line;
  closing.blankEnd = std::max(line, text.lastIndexOf(QLatin1Char('\n'), next - 1) + 1);
  return closing;
}

XmlNewLine newLineAt(const QString& text, int position) {
  const QString indent = indentOf(text, position);
  XmlNewLine line{QLatin1Char('\n') + indent, 0};
  for (const XmlTag& tag : xmlTags(text)) {
    if (tag.begin >= position) break;
    if (tag.kind != XmlTag::Kind::kOpening || !tag.isComplete || tag.end > position) continue;
    if (!text.mid(tag.end, position - tag.end).trimmed().isEmpty()) continue;
    // Only a tag in this line makes the next one deeper.
    if (text.mid(tag.end, position - tag.end).contains(QLatin1Char('\n'))) continue;
    const bool isFollowed = text.midRef(position).startsWith(QLatin1String("</"));
    line.text += QStringLiteral("  ");
    if (isFollowed) {
      line.back = indent.size() + 1;
      line.text += QLatin1Char('\n') + indent;
    }
    break;
  }
  return line;
}

}  // namespace widgets
