// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/console/CommandTyping.h"

#include <algorithm>

#include "robotlink/commands/CommandCompletion.h"
#include "robotlink/commands/CommandTable.h"

namespace widgets {
namespace {

using robotlink::CommandTable;

QString hintFor(const CommandTable::Command& command, std::size_t current) {
  QString hint = QString::fromStdString(command.name).toHtmlEscaped();
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const auto& argument = command.arguments[i];
    const QString name = QString::fromStdString(argument.name).toHtmlEscaped();
    const QString shown = argument.isOptional() ? QStringLiteral("[%1]").arg(name) : name;
    hint += i == current ? QStringLiteral(" <b>%1</b>").arg(shown) : QLatin1Char(' ') + shown;
  }
  if (current >= command.arguments.size()) return hint;
  const QString help = QString::fromStdString(command.arguments[current].help).toHtmlEscaped();
  return help.isEmpty() ? hint : QStringLiteral("%1 – %2").arg(hint, help);
}

/// The number of characters in which all texts agree.
int commonLength(const QStringList& texts) {
  int length = texts.first().size();
  for (const QString& text : texts) {
    const auto [end, other] =
        std::mismatch(texts.first().begin(), texts.first().begin() + length, text.begin(), text.end());
    length = static_cast<int>(end - texts.first().begin());
  }
  return length;
}

}  // namespace

TypedCommand typedCommand(const CommandTable& commands, const QString& line, int cursor) {
  const std::string before = line.left(cursor).toStdString();
  const robotlink::Completion completion = robotlink::complete(commands, before, before.size());
  TypedCommand typed;
  typed.from = QString::fromStdString(before.substr(0, completion.from)).size();
  for (const std::string& text : completion.candidates) typed.candidates << QString::fromStdString(text);
  if (completion.command != nullptr) typed.hint = hintFor(*completion.command, completion.argument);
  return typed;
}

TypedLine replaced(const TypedLine& typed, int from, const QString& text) {
  const QString rest = typed.line.mid(typed.cursor);
  const QString begin = typed.line.left(from) + text;
  if (text.endsWith(QLatin1Char('/'))) return {begin + rest, begin.size()};  // a folder, whose files follow
  if (rest.startsWith(QLatin1Char(' '))) return {begin + rest, begin.size() + 1};
  return {begin + QLatin1Char(' ') + rest, begin.size() + 1};
}

TypedLine completed(const CommandTable& commands, const TypedLine& typed) {
  const TypedCommand known = typedCommand(commands, typed.line, typed.cursor);
  if (known.candidates.isEmpty()) return typed;
  if (known.candidates.size() == 1) return replaced(typed, known.from, known.candidates.first());
  const QString common = known.candidates.first().left(commonLength(known.candidates));
  // An unfinished quote would end the word.
  if (common.size() <= typed.cursor - known.from || common.contains(QLatin1Char('"'))) return typed;
  return {typed.line.left(known.from) + common + typed.line.mid(typed.cursor), known.from + common.size()};
}

}  // namespace widgets
