// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "robotlink/base/bytes/LittleEndian.h"

namespace robotlink {

/// Appends little-endian values to a vector, which must outlive this object. ByteReader reads them.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<std::uint8_t>& out) : out_(out) {}

  /// Appends a number of fixed width.
  template <FixedWidth Number>
  void put(Number number) {
    std::uint8_t bytes[sizeof number];
    storeNumber(bytes, number);
    out_.insert(out_.end(), bytes, bytes + sizeof number);
  }
  /// Appends bytes without their length.
  void put(std::span<const std::uint8_t> bytes) { out_.insert(out_.end(), bytes.begin(), bytes.end()); }
  /// Appends a text with its length before it in 32 bits.
  void put(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size()));
    out_.insert(out_.end(), text.begin(), text.end());
  }

 private:
  std::vector<std::uint8_t>& out_;
};

}  // namespace robotlink
