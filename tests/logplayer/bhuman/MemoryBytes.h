// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "logplayer/bhuman/ByteSource.h"

namespace logplayer::bhuman {

/// Bytes in memory, which must outlive this object.
class MemoryBytes final : public ByteSource {
 public:
  explicit MemoryBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint64_t size() const override { return bytes_.size(); }
  std::size_t read(std::uint64_t offset, std::span<std::uint8_t> to) override {
    if (offset >= bytes_.size()) return 0;
    const auto from = bytes_.subspan(static_cast<std::size_t>(offset));
    const std::size_t count = std::min(from.size(), to.size());
    std::copy_n(from.begin(), count, to.begin());
    return count;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

inline std::unique_ptr<ByteSource> bytesInMemory(std::span<const std::uint8_t> bytes) {
  return std::make_unique<MemoryBytes>(bytes);
}

}  // namespace logplayer::bhuman
