// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/XmlText.h"

#include <QStringList>
#include <algorithm>

namespace widgets {
namespace {

constexpr int kXmlIndent = 2;

bool isXmlNameChar(QChar c) {
  return c.isLetterOrNumber() || c == QLatin1Char('_') || c == QLatin1Char('-') || c == QLatin1Char(':') ||
         c == QLatin1Char('.');
}

int nameEnd(const QString& text, int from) {
  while (from < text.size() && isXmlNameChar(text[from])) ++from;
  return from;
}

/// The end of something that only `close` ends; the end of the text if it does not come.
XmlTag otherTag(const QString& text, int begin, const QString& close) {
  const int at = text.indexOf(close, begin);
  return {XmlTag::Kind::kOther, {}, begin, at < 0 ? text.size() : at + close.size(), at >= 0};
}

/// The tag that begins at a '<'.
XmlTag tagAt(const QString& text, int begin) {
  const QStringRef rest = text.midRef(begin);
  if (rest.startsWith(QLatin1String("<!--"))) return otherTag(text, begin, QStringLiteral("-->"));
  if (rest.startsWith(QLatin1String("<![CDATA["))) return otherTag(text, begin, QStringLiteral("]]>"));
  if (rest.startsWith(QLatin1String("<?"))) return otherTag(text, begin, QStringLiteral("?>"));
  if (rest.startsWith(QLatin1String("<!"))) return otherTag(text, begin, QStringLiteral(">"));
  XmlTag tag{XmlTag::Kind::kOpening, {}, begin, begin + 1, false};
  if (tag.end < text.size() && text[tag.end] == QLatin1Char('/')) {
    tag.kind = XmlTag::Kind::kClosing;
    ++tag.end;
  }
  const int named = nameEnd(text, tag.end);
  tag.name = text.mid(tag.end, named - tag.end);
  tag.end = named;
  QChar quote;
  for (; tag.end < text.size(); ++tag.end) {
    const QChar c = text[tag.end];
    // XML allows no "<" in values, so the previous tag is incomplete.
    if (c == QLatin1Char('<')) return tag;
    if (!quote.isNull()) {
      if (c == quote) quote = {};
    } else if (c == QLatin1Char('"') || c == QLatin1Char('\'')) {
      quote = c;
    } else if (c == QLatin1Char('>')) {
      if (text[tag.end - 1] == QLatin1Char('/') && tag.kind == XmlTag::Kind::kOpening)
        tag.kind = XmlTag::Kind::kEmpty;
      ++tag.end;
      tag.isComplete = true;
      return tag;
    }
  }
  return tag;
}

/// Closes the open elements from the one at `first` of the stack on; only that has a closing tag, if any.
void closeElements(std::vector<XmlElement>& all, std::vector<int>& open, std::size_t first, int at,
                   const XmlTag* closing) {
  for (std::size_t i = open.size(); i-- > first;) {
    XmlElement& element = all[static_cast<std::size_t>(open[i])];
    const bool isMeant = closing != nullptr && i == first;
    element.closeBegin = at;
    element.end = isMeant ? closing->end : at;
    element.isClosed = isMeant;
  }
  open.resize(first);
}

}  // namespace

std::vector<XmlTag> xmlTags(const QString& text) {
  std::vector<XmlTag> tags;
  for (int at = text.indexOf(QLatin1Char('<')); at >= 0; at = text.indexOf(QLatin1Char('<'), at)) {
    tags.push_back(tagAt(text, at));
    at = tags.back().end;
  }
  return tags;
}

QMap<QString, QString> xmlAttributes(const QString& text, const XmlTag& tag) {
  QMap<QString, QString> attributes;
  int at = tag.begin + 1 + tag.name.size();
  while (at < tag.end) {
    while (at < tag.end && !isXmlNameChar(text[at])) ++at;
    const int named = std::min(nameEnd(text, at), tag.end);
    const QString name = text.mid(at, named - at);
    at = named;
    while (at < tag.end && (text[at].isSpace() || text[at] == QLatin1Char('='))) ++at;
    if (name.isEmpty() || at >= tag.end) break;
    const QChar quote = text[at];
    if (quote != QLatin1Char('"') && quote != QLatin1Char('\'')) continue;
    const int close = text.indexOf(quote, at + 1);
    const int end = close < 0 ? tag.end : std::min(close, tag.end);
    attributes[name] = text.mid(at + 1, end - at - 1);
    at = end + 1;
  }
  return attributes;
}

std::vector<XmlElement> xmlElements(const QString& text) {
  std::vector<XmlElement> all;
  std::vector<int> open;
  for (const XmlTag& tag : xmlTags(text)) {
    if (tag.kind == XmlTag::Kind::kOther) continue;
    if (tag.kind == XmlTag::Kind::kClosing) {
      const auto matching = std::find_if(open.rbegin(), open.rend(), [&](int index) {
        return all[static_cast<std::size_t>(index)].name == tag.name;
      });
      if (matching == open.rend()) continue;
      closeElements(all, open, static_cast<std::size_t>(open.rend() - matching) - 1, tag.begin, &tag);
      continue;
    }
    const bool isEmpty = tag.kind == XmlTag::Kind::kEmpty;
    all.push_back({tag.name, tag.begin, tag.end, tag.end, tag.end, isEmpty, open.empty() ? -1 : open.back()});
    if (!isEmpty) open.push_back(static_cast<int>(all.size()) - 1);
  }
  closeElements(all, open, 0, text.size(), nullptr);
  return all;
}

QString indentedXml(const QString& text) {
  const auto tags = xmlTags(text);
  QStringList lines = text.split(QLatin1Char('\n'));
  int position = 0, depth = 0;
  auto tag = tags.begin();
  for (QString& line : lines) {
    // Tags that begin before the line count for it.
    while (tag != tags.end() && tag->end <= position) {
      if (tag->kind == XmlTag::Kind::kOpening) ++depth;
      if (tag->kind == XmlTag::Kind::kClosing) --depth;
      ++tag;
    }
    const int next = position + line.size() + 1;
    const bool isWithin = tag != tags.end() && tag->begin < position;
    const QString words = line.trimmed();
    if (!isWithin) {
      const int around = words.startsWith(QLatin1String("</")) ? depth - 1 : depth;
      line =
          words.isEmpty() ? QString() : QString(kXmlIndent * std::max(0, around), QLatin1Char(' ')) + words;
    }
    position = next;
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace widgets
