// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace robotlink {

/// Splits untrusted bytes into lines, which end with a line feed. Never keeps more than what was fed
/// last and kMaxLine bytes.
class LineReader {
 public:
  static constexpr std::size_t kMaxLine = 16'384;

  /// Appends bytes; ignored once a line was too long.
  void feed(std::string_view bytes);
  /// The next complete line without its end; empty if there is none yet.
  std::optional<std::string> next();
  /// Whether a line was longer than kMaxLine. Nothing follows it, since its meaning is unknown.
  bool isTooLong() const { return isTooLong_; }

 private:
  std::string bytes_;
  bool isTooLong_ = false;
};

}  // namespace robotlink
