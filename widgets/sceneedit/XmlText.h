// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QString>
#include <vector>

namespace widgets {

// A tolerant reader of XML that is being typed and therefore mostly not well-formed. Positions count the
// characters of the text from 0, as a QTextCursor does; ends are behind the last character. All functions are
// pure and take time in proportion to the text.

/// A tag, or what is between '<' and '>' otherwise.
struct XmlTag {
  /// kOther: a comment, CDATA, a declaration or the like.
  enum class Kind { kOpening, kClosing, kEmpty, kOther };
  Kind kind = Kind::kOpening;
  QString name;
  int begin = 0, end = 0;
  /// False: it breaks off at the next '<' or at the end of the text.
  bool isComplete = false;
};

/// All tags of a text, in its order.
std::vector<XmlTag> xmlTags(const QString& text);
/// The attributes of an opening or empty tag.
QMap<QString, QString> xmlAttributes(const QString& text, const XmlTag& tag);

/// An element: its opening tag, and its closing one if it has one.
struct XmlElement {
  QString name;
  /// The opening tag.
  int begin = 0, openEnd = 0;
  /// The closing tag; both are behind the opening tag if that is empty, and at the end of what the element
  /// can contain if it was not closed.
  int closeBegin = 0, end = 0;
  bool isClosed = false;
  /// An index of the elements; -1: none is around it.
  int parent = -1;
};

/// All elements of a text, in the order of their opening tags. A closing tag closes the innermost open
/// element of its name and all within it; others are passed over.
std::vector<XmlElement> xmlElements(const QString& text);

/// The text with each line indented by two blanks for each element around it. Lines that begin within a tag,
/// a comment or CDATA stay as they are.
QString indentedXml(const QString& text);

}  // namespace widgets
