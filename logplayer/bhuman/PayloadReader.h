// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace logplayer::bhuman {

/// Reads little-endian values from a payload, which must outlive this object. Values past the end are 0; from
/// then on complete() is false.
class PayloadReader {
 public:
  explicit PayloadReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// Each function reads the next value.
  std::uint8_t takeByte() { return static_cast<std::uint8_t>(take(1)); }
  std::int16_t takeInt16() { return static_cast<std::int16_t>(take(2)); }
  std::int32_t takeInt32() { return static_cast<std::int32_t>(take(4)); }
  std::uint32_t takeUint32() { return static_cast<std::uint32_t>(take(4)); }
  float takeFloat() { return std::bit_cast<float>(takeUint32()); }
  double takeDouble() { return std::bit_cast<double>(take(8)); }
  /// B-Human's streams store a bool in four bytes.
  bool takeBool() { return take(4) != 0; }
  /// Skips bytes; fails like reading if there are fewer.
  void skip(std::size_t count) { taken(count); }

  /// Whether all values were available and no bytes are left.
  bool complete() const { return complete_ && bytes_.empty(); }
  /// The bytes that have not been read.
  std::span<const std::uint8_t> rest() const { return bytes_; }

 private:
  /// Reads a number of `count` bytes, at most 8.
  std::uint64_t take(std::size_t count) {
    std::uint64_t value = 0;
    const auto bytes = taken(count);
    for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8U | bytes[i];
    return value;
  }
  /// Removes `count` bytes from the front; empty if there are fewer.
  std::span<const std::uint8_t> taken(std::size_t count) {
    if (count > bytes_.size()) {
      complete_ = false;
      bytes_ = {};
      return {};
    }
    const auto result = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return result;
  }

  std::span<const std::uint8_t> bytes_;
  bool complete_ = true;
};

}  // namespace logplayer::bhuman
