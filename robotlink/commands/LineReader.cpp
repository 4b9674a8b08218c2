// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/LineReader.h"

#include <algorithm>

namespace robotlink {

void LineReader::feed(std::string_view bytes) {
  if (!isTooLong_) bytes_ += bytes;
}

std::optional<std::string> LineReader::next() {
  const std::size_t end = std::min(bytes_.find('\n'), bytes_.size());
  if (end > kMaxLine) {
    isTooLong_ = true;
    bytes_.clear();
  }
  if (end >= bytes_.size()) return std::nullopt;
  std::string line = bytes_.substr(0, end);
  bytes_.erase(0, end + 1);
  return line;
}

}  // namespace robotlink
