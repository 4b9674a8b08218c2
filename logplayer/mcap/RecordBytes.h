// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <concepts>
#include <cstring>
#include <string_view>

#include "logplayer/mcap/Records.h"

namespace logplayer::mcap {

/// Writes a number in little-endian order to `to`, which must have room for sizeof(Number) bytes.
template <std::unsigned_integral Number>
void storeNumber(std::uint8_t* to, Number number) {
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(to, &number, sizeof number);
  } else {
    for (std::size_t i = 0; i < sizeof number; ++i) to[i] = static_cast<std::uint8_t>(number >> (8 * i));
  }
}

/// Reads a number in little-endian order from `from`, where sizeof(Number) bytes must be readable.
template <std::unsigned_integral Number>
Number loadNumber(const std::uint8_t* from) {
  Number number = 0;
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(&number, from, sizeof number);
  } else {
    for (std::size_t i = 0; i < sizeof number; ++i) {
      number = static_cast<Number>(number | static_cast<Number>(static_cast<Number>(from[i]) << (8 * i)));
    }
  }
  return number;
}

/// The characters of a text as bytes, and back, without a copy.
inline Bytes bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline std::string_view textOf(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Appends little-endian values to a vector, which must outlive this object.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<std::uint8_t>& out) : out_(out) {}

  /// Appends a number of fixed width.
  template <std::unsigned_integral Number>
  void put(Number number) {
    std::uint8_t bytes[sizeof number];
    storeNumber(bytes, number);
    out_.insert(out_.end(), bytes, bytes + sizeof number);
  }
  /// Appends bytes without their length.
  void put(Bytes bytes) { out_.insert(out_.end(), bytes.begin(), bytes.end()); }
  /// Appends a text with its length before it in 32 bits.
  void put(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size()));
    put(bytesOf(text));
  }

 private:
  std::vector<std::uint8_t>& out_;
};

/// Reads little-endian values from bytes, which must outlive this object. Values past the end are 0 or empty;
/// from then on good() is false. So a decoder can read all fields and check once.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  /// Reads a number of fixed width.
  template <std::unsigned_integral Number>
  Number take() {
    const Bytes bytes = take(sizeof(Number));
    return bytes.empty() ? Number{0} : loadNumber<Number>(bytes.data());
  }
  /// Reads `count` bytes, as a view.
  Bytes take(std::uint64_t count) {
    if (count > bytes_.size()) {
      good_ = false;
      bytes_ = {};
      return {};
    }
    const Bytes taken = bytes_.first(static_cast<std::size_t>(count));
    bytes_ = bytes_.subspan(static_cast<std::size_t>(count));
    return taken;
  }
  /// Reads a text with its length before it in 32 bits.
  std::string_view takeText() { return textOf(take(take<std::uint32_t>())); }

  /// Whether all values so far were complete.
  bool good() const { return good_; }
  /// The bytes that have not been read.
  Bytes rest() const { return bytes_; }

 private:
  /// The rest; empty once a value was incomplete.
  Bytes bytes_;
  bool good_ = true;
};

}  // namespace logplayer::mcap
