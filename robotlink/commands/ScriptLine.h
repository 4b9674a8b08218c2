// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "robotlink/base/Error.h"

namespace robotlink {

/// A parsed line of a script; SCRIPTS.md describes the syntax. A plain value.
struct ScriptLine {
  enum class Kind {
    /// An empty line, or a comment.
    kNothing,
    /// A command, as CommandTable::runLine() reads it.
    kCommand,
    /// `wait until EXPRESSION [for SECONDS]`
    kWaitUntil,
    /// `wait SECONDS`
    kWait,
    /// `assert EXPRESSION`
    kAssert,
    /// `print EXPRESSION`
    kPrint,
    /// `set NAME VALUE`
    kSet,
    /// `include FILE`
    kInclude
  };
  Kind kind = Kind::kNothing;
  /// The command, the expression, the name of a variable, or the file.
  std::string text = {};
  /// The value of a variable.
  std::string value = {};
  /// The duration of a wait; for kWaitUntil the longest one.
  double seconds = 0;
  /// The position of `text` in the line, in bytes from 1.
  int column = 1;
};

/// How long `wait until` waits if nothing else is said, in seconds.
inline constexpr double kDefaultScriptWait = 30;

/// Returns the value of a variable; empty if there is none of this name.
using ScriptVariables = std::function<std::optional<std::string>(const std::string& name)>;

/// Replaces `$NAME` and `${NAME}` by their values, except inside of '...', and `$$` by one `$`. Fails, with
/// the column, if there is no such variable. A comment is left out.
Result<std::string> withVariables(const std::string& line, const ScriptVariables& variables);

/// Reads a line, whose variables are replaced already. Errors have their column in Error::where.
Result<ScriptLine> readScriptLine(const std::string& line);

}  // namespace robotlink
