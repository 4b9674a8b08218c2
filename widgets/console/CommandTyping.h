// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace robotlink {
class CommandTable;
}

// Completion and hints while a command line is typed. Positions are in characters of the QString.
namespace widgets {

/// The completions of the word at the cursor, and what comes next.
struct TypedCommand {
  /// The position at which the word begins that a candidate replaces; it ends at the cursor.
  int from = 0;
  QStringList candidates;
  /// The command with its arguments, of which the current one is bold, and the argument's help, as rich text;
  /// empty while the command's name is typed.
  QString hint;
  bool operator==(const TypedCommand&) const = default;
};

TypedCommand typedCommand(const robotlink::CommandTable& commands, const QString& line, int cursor);

/// A line and a cursor in it.
struct TypedLine {
  QString line;
  int cursor = 0;
};

/// The line after the word at the cursor was replaced by a text, with a blank behind it unless one follows.
TypedLine replaced(const TypedLine& typed, int from, const QString& text);
/// The line after the word was completed as far as all candidates agree; the only candidate gets a blank.
TypedLine completed(const robotlink::CommandTable& commands, const TypedLine& typed);

}  // namespace widgets
