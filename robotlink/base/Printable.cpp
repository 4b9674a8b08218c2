// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Printable.h"

#include <algorithm>

#include "robotlink/base/Utf8.h"

namespace robotlink {

std::string printable(const std::string& text) {
  std::string line = printableLines(text);
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return line;
}

std::string printableLines(const std::string& text, const std::string& indent) {
  const std::string valid = validUtf8(text);
  std::string lines;
  lines.reserve(valid.size());
  for (std::size_t at = 0; at < valid.size(); ++at) {
    const auto byte = static_cast<unsigned char>(valid[at]);
    // U+0080 to U+009F are C2 80 to C2 9F.
    const bool isC1 = byte == 0xC2 && static_cast<unsigned char>(valid[at + 1]) < 0xA0;
    if (isC1) ++at;
    if (byte == '\n') {
      lines += '\n' + indent;
    } else if (byte == '\r') {
      lines += ' ';
    } else {
      lines += isC1 || (byte < 0x20 && byte != '\t') || byte == 0x7F ? '?' : valid[at];
    }
  }
  return lines;
}

std::string escapedMarkup(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
        result += "&#10;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace robotlink
