// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace google::protobuf {
class Message;
}

namespace widgets {

/// The words that a user searches in the tree of all data: a row is found if its path, with the title of its
/// stream, contains each of them, in any case of letters.
class DataFilter {
 public:
  /// Words are separated by spaces; without any, everything is found.
  void setWords(const QString& text) { words_ = text.split(QLatin1Char(' '), Qt::SkipEmptyParts); }
  bool isEmpty() const { return words_.isEmpty(); }
  bool finds(const QString& path) const;
  /// Whether a field of the message is found, at any depth, among the first elements of lists; `path` is that
  /// of the message. Its cost is bounded.
  bool findsWithin(const QString& path, const google::protobuf::Message& message) const;

 private:
  /// `budget`: the number of further fields to examine.
  bool findsWithin(const QString& path, const google::protobuf::Message& message, int& budget) const;

  QStringList words_;
};

}  // namespace widgets
