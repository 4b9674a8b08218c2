// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "robotlink/base/bytes/LittleEndian.h"

namespace robotlink {

/// Reads little-endian values from bytes, which must outlive this object. Values past the end are 0 or empty;
/// from then on good() is false. So a decoder can read all fields and check once. Lengths are not trusted:
/// nothing is read past the end, and nothing is allocated.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// Reads a number of fixed width.
  template <FixedWidth Number>
  Number take() {
    const auto bytes = take(sizeof(Number));
    return bytes.empty() ? Number{0} : loadNumber<Number>(bytes.data());
  }
  /// Reads `count` bytes, as a view.
  std::span<const std::uint8_t> take(std::uint64_t count) {
    if (count > bytes_.size()) {
      good_ = false;
      bytes_ = {};
      return {};
    }
    const auto taken = bytes_.first(static_cast<std::size_t>(count));
    bytes_ = bytes_.subspan(static_cast<std::size_t>(count));
    return taken;
  }
  /// Reads a text with its length before it in 32 bits, as a view.
  std::string_view takeText() {
    const auto text = take(take<std::uint32_t>());
    return {reinterpret_cast<const char*>(text.data()), text.size()};
  }

  /// Whether all values so far were complete.
  bool good() const { return good_; }
  /// Whether all values were complete, and no bytes are left.
  bool complete() const { return good_ && bytes_.empty(); }
  /// The bytes that have not been read; empty once a value was incomplete.
  std::span<const std::uint8_t> rest() const { return bytes_; }

 private:
  std::span<const std::uint8_t> bytes_;
  bool good_ = true;
};

}  // namespace robotlink
