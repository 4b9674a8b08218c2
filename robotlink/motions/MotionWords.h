// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace robotlink {

/// A word of a line of a motion file.
struct MotionWord {
  std::string_view text;
  int column = 1;  ///< in bytes, from 1
};

/// The words of a line, without its comment; '=' is a word of its own. They refer to `row`.
std::vector<MotionWord> motionWords(std::string_view row);

/// Returns the position of a line's comment, an index into `row`; its size if there is none.
std::size_t motionCommentStart(std::string_view row);

/// Splits a text into its lines, without their line breaks. An empty text, and one that ends in a line break,
/// end in an empty line. They refer to `text`.
std::vector<std::string_view> motionRows(std::string_view text);

}  // namespace robotlink
