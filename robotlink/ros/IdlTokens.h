// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace robotlink::ros {

/// Splits OMG IDL into words ("uint32", "std_msgs::msg::Header", "-7", "\"text\"") and single symbols.
/// Comments, lines of the preprocessor, and what stands between the files of a schema ("====", "IDL: name")
/// are left out. The text must outlive it.
class IdlTokens {
 public:
  explicit IdlTokens(std::string_view text) : rest_(text) { advance(); }

  /// The current token; empty at the end.
  std::string_view current() const { return current_; }
  /// Returns the line of the current token, from 1.
  int line() const { return line_; }
  /// Moves on, and returns the token that was the current one.
  std::string_view take() {
    const std::string_view taken = current_;
    advance();
    return taken;
  }
  /// Moves on if this is the current token.
  bool take(std::string_view token) {
    if (current_ != token) return false;
    advance();
    return true;
  }

 private:
  void advance();
  /// Skips what is no token; returns whether there was anything.
  bool skip();
  void drop(std::size_t count);

  std::string_view rest_, current_;
  /// The lines of the current token and of the rest.
  int line_ = 1, restLine_ = 1;
  bool isLineStart_ = true;
};

}  // namespace robotlink::ros
