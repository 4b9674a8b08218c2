// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/ScriptLine.h"

#include <cmath>
#include <string_view>
#include <vector>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/commands/CommandLine.h"
#include "robotlink/expressions/NameCharacters.h"

namespace robotlink {
namespace {

using Kind = ScriptLine::Kind;

constexpr std::string_view kScriptBlanks = " \t\r\n";

tl::unexpected<Error> wrong(std::string text, std::size_t at) {
  return failure("script.syntax", std::move(text), {{}, 0, static_cast<int>(at) + 1});
}

bool isBlank(char c) {
  return kScriptBlanks.find(c) != std::string_view::npos;
}

/// Returns the begin of a line's comment, outside of quotes; the line's length if there is none.
std::size_t endOf(const std::string& line) {
  char quote = 0;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (quote != 0) {
      if (c == '\\' && quote == '"') ++at;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#' && (at == 0 || isBlank(line[at - 1]))) {
      return at;
    }
  }
  return line.size();
}

/// A part of a line without blanks around it, and where it begins.
struct Part {
  std::string text;
  std::size_t at = 0;
};

Part trimmed(const std::string& line, std::size_t from, std::size_t to) {
  from = std::min(line.find_first_not_of(kScriptBlanks, from), to);
  while (to > from && isBlank(line[to - 1])) --to;
  return {line.substr(from, to - from), from};
}

/// Cuts off the first word of a part.
Part takeWord(const std::string& line, Part& part) {
  const std::size_t length = std::min(part.text.find_first_of(kScriptBlanks), part.text.size());
  Part word{part.text.substr(0, length), part.at};
  part = trimmed(line, part.at + length, part.at + part.text.size());
  return word;
}

std::optional<double> secondsIn(const std::string& text) {
  const auto seconds = parsedNumber<double>(text);
  return seconds && std::isfinite(*seconds) && *seconds >= 0 ? seconds : std::nullopt;
}

Result<ScriptLine> readWaitUntil(const std::string& line, Part expression) {
  ScriptLine read{.kind = Kind::kWaitUntil, .seconds = kDefaultScriptWait};
  const std::size_t last = expression.text.find_last_of(kScriptBlanks);
  if (last != std::string::npos) {
    const Part before = trimmed(line, expression.at, expression.at + last);
    const bool isFor = before.text == "for" || (before.text.size() > 3 && before.text.ends_with("for") &&
                                                isBlank(before.text[before.text.size() - 4]));
    const auto seconds = secondsIn(expression.text.substr(last + 1));
    if (isFor && seconds) {
      read.seconds = *seconds;
      expression = trimmed(line, before.at, before.at + before.text.size() - 3);
    }
  }
  if (expression.text.empty()) return wrong("wait until needs a condition", expression.at);
  read.text = expression.text;
  read.column = static_cast<int>(expression.at) + 1;
  return read;
}

Result<ScriptLine> readWait(const std::string& line, Part rest) {
  const std::size_t at = rest.at;
  const Part word = takeWord(line, rest);
  if (word.text == "until") return readWaitUntil(line, rest);
  const auto seconds = secondsIn(word.text);
  if (!seconds || !rest.text.empty())
    return wrong(
        "wait takes a number of seconds, or until and a condition: wait 2.5, wait until "
        "simulation.time > 5 for 10",
        at);
  return ScriptLine{.kind = Kind::kWait, .seconds = *seconds};
}

/// The words after the first one of a line.
Result<std::vector<CommandWord>> argumentsOf(const std::string& line, std::size_t count, const char* usage) {
  auto words = splitCommandLine(line);
  if (!words) return tl::unexpected(words.error());
  if (words->size() != count + 1) return wrong(usage, static_cast<std::size_t>(words->front().column - 1));
  words->erase(words->begin());
  return words;
}

Result<ScriptLine> readSet(const std::string& line) {
  const auto words = argumentsOf(line, 2, "set takes a name and a value; a value with spaces is quoted");
  if (!words) return tl::unexpected(words.error());
  const std::string& name = words->front().text;
  for (const char c : name) {
    if (!isNameCharacter(c))
      return wrong("a variable's name has letters, digits and _ only",
                   static_cast<std::size_t>(words->front().column - 1));
  }
  return ScriptLine{
      .kind = Kind::kSet, .text = name, .value = words->back().text, .column = words->front().column};
}

}  // namespace

Result<std::string> withVariables(const std::string& original, const ScriptVariables& variables) {
  const std::string line = original.substr(0, endOf(original));
  std::string result;
  bool isLiteral = false, isQuoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '\'' && !isQuoted) isLiteral = !isLiteral;
    if (c == '"' && !isLiteral) isQuoted = !isQuoted;
    if (c == '\\' && isQuoted && at + 1 < line.size()) {
      result.append({c, line[++at]});
      continue;
    }
    const char next = at + 1 < line.size() ? line[at + 1] : ' ';
    if (c != '$' || isLiteral || (next != '$' && next != '{' && !beginsName(next))) {
      result += c;
      continue;
    }
    if (next == '$') {
      result += line[++at];
      continue;
    }
    const std::size_t begin = at + (next == '{' ? 2 : 1);
    std::size_t end = begin;
    while (end < line.size() && isNameCharacter(line[end])) ++end;
    const std::string name = line.substr(begin, end - begin);
    if (next == '{' && (name.empty() || end == line.size() || line[end] != '}'))
      return wrong("${ needs a name and }", at);
    const auto value = variables(name);
    if (!value) return wrong("there is no variable " + name + "; set " + name + " VALUE defines it", at);
    result += *value;
    at = next == '{' ? end : end - 1;
  }
  return result;
}

Result<ScriptLine> readScriptLine(const std::string& line) {
  Part rest = trimmed(line, 0, endOf(line));
  if (rest.text.empty()) return ScriptLine{};
  const Part all = rest;
  const Part word = takeWord(line, rest);
  if (word.text == "wait") return readWait(line, rest);
  if (word.text == "set") return readSet(line);
  if (word.text == "assert" || word.text == "print") {
    const bool isAssert = word.text == "assert";
    if (rest.text.empty())
      return wrong(isAssert ? "assert needs a condition" : "print needs an expression",
                   all.at + all.text.size());
    return ScriptLine{.kind = isAssert ? Kind::kAssert : Kind::kPrint,
                      .text = rest.text,
                      .column = static_cast<int>(rest.at) + 1};
  }
  if (word.text == "include") {
    const auto words = argumentsOf(line, 1, "include takes one file");
    if (!words) return tl::unexpected(words.error());
    return ScriptLine{.kind = Kind::kInclude, .text = words->front().text, .column = words->front().column};
  }
  // A short name for the view's command, which reads better in a script.
  constexpr std::string_view kScreenshot = "screenshot";
  std::string command = all.text;
  if (word.text == kScreenshot) command.replace(0, kScreenshot.size(), "view.screenshot");
  return ScriptLine{.kind = Kind::kCommand, .text = command, .column = static_cast<int>(all.at) + 1};
}

}  // namespace robotlink
