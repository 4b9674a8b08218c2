// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/IdlTokens.h"

#include <algorithm>
#include <cctype>

namespace robotlink::ros {
namespace {

bool isWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == ':' || c == '-' ||
         c == '+';
}

}  // namespace

void IdlTokens::drop(std::size_t count) {
  count = std::min(count, rest_.size());
  for (const char c : rest_.substr(0, count)) {
    if (c == '\n') ++restLine_;
    if (std::isspace(static_cast<unsigned char>(c)) == 0) isLineStart_ = false;
    if (c == '\n') isLineStart_ = true;
  }
  rest_.remove_prefix(count);
}

bool IdlTokens::skip() {
  if (rest_.empty()) return false;
  const std::size_t line = std::min(rest_.find('\n'), rest_.size());
  const bool isBetweenFiles = isLineStart_ && (rest_.starts_with("==") || rest_.starts_with("IDL:"));
  if (std::isspace(static_cast<unsigned char>(rest_[0])) != 0) {
    drop(1);
  } else if (isBetweenFiles || rest_.starts_with("//") || (isLineStart_ && rest_[0] == '#')) {
    drop(line);
  } else if (rest_.starts_with("/*")) {
    const std::size_t end = rest_.find("*/", 2);
    drop(end == std::string_view::npos ? end : end + 2);
  } else {
    return false;
  }
  return true;
}

void IdlTokens::advance() {
  while (skip()) {
  }
  line_ = restLine_;
  std::size_t length = rest_.empty() ? 0 : 1;
  if (length > 0 && rest_[0] == '"') {
    while (length < rest_.size() && rest_[length] != '"') length += rest_[length] == '\\' ? 2 : 1;
    length = std::min(length + 1, rest_.size());
  } else if (length > 0 && isWord(rest_[0])) {
    while (length < rest_.size() && isWord(rest_[length])) ++length;
  }
  current_ = rest_.substr(0, length);
  drop(length);
}

}  // namespace robotlink::ros
