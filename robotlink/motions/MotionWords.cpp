// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionWords.h"

#include <algorithm>

namespace robotlink {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\0';
}

}  // namespace

std::size_t motionCommentStart(std::string_view row) {
  return std::min({row.find('"'), row.find("//"), row.size()});
}

std::vector<MotionWord> motionWords(std::string_view row) {
  row = row.substr(0, motionCommentStart(row));
  std::vector<MotionWord> words;
  for (std::size_t i = 0; i < row.size();) {
    std::size_t end = i + 1;
    if (isBlank(row[i])) {
      i = end;
      continue;
    }
    if (row[i] != '=') {
      while (end < row.size() && !isBlank(row[end]) && row[end] != '=') ++end;
    }
    words.push_back({row.substr(i, end - i), static_cast<int>(i) + 1});
    i = end;
  }
  return words;
}

std::vector<std::string_view> motionRows(std::string_view text) {
  std::vector<std::string_view> rows;
  while (true) {
    const std::size_t end = text.find('\n');
    rows.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return rows;
    text.remove_prefix(end + 1);
  }
}

}  // namespace robotlink
