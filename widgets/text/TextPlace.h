// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace widgets {

/// The cursor and scroll position in an edited text: an editor keeps it for its successor, or for the
/// next time when the text is shown.
struct TextPlace {
  /// The cursor and the other end of the selection, in characters.
  int position = 0, anchor = 0;
  /// The values of the scroll bars.
  int top = 0, left = 0;

  bool operator==(const TextPlace&) const = default;
};

}  // namespace widgets
