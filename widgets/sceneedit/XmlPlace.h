// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace widgets {

/// The context of a position in an XML text, for completion. A plain value.
struct XmlPlace {
  enum class Kind {
    kText,            ///< between tags
    kTagName,         ///< in the name of an opening tag, or directly behind its '<'
    kClosingName,     ///< the same of a closing tag
    kAttributeName,   ///< in an opening tag where the name of an attribute is or may begin
    kAttributeValue,  ///< between its quotes
    kElsewhere        ///< in a comment, in CDATA, behind an attribute's '='
  };
  Kind kind = Kind::kText;
  /// The elements around the place, from the root on; without the one whose tag it is in.
  QStringList path;
  /// The name of the tag that it is in, and those of the attributes that this tag has.
  QString element;
  QStringList attributes;
  /// Only for kAttributeValue.
  QString attribute;
  /// The part of the word before the place (for text: since the last tag), and the position where it begins.
  QString prefix;
  int prefixBegin = 0;
};

XmlPlace xmlPlaceAt(const QString& text, int position);

/// The text to be inserted behind a '>' that was typed directly before the position: "</link>" if it ends the
/// opening tag of an element that is not closed yet; otherwise nothing.
QString closingTagFor(const QString& text, int position);
/// The end of the element around a position, for a closing tag that begins there.
struct XmlClosing {
  /// "link>"; empty if nothing is open.
  QString name;
  /// Behind the closing tag if there are only blanks before it, so that no other one is needed; otherwise -1.
  int end = -1;
  /// The blank lines before it from that of the position on; the same if there are none.
  int blankBegin = 0, blankEnd = 0;
};
XmlClosing closingAt(const QString& text, int position);
/// The text to be inserted for a new line at a position, with its indentation. `back`: by how many characters
/// the cursor is before the end of that, if a closing tag follows and gets a line of its own.
struct XmlNewLine {
  QString text;
  int back = 0;
};
XmlNewLine newLineAt(const QString& text, int position);

}  // namespace widgets
