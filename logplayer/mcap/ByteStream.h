// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <concepts>
#include <cstring>
#include <string_view>

#include "logplayer/mcap/Records.h"

namespace logplayer::mcap {

/// Writes a little-endian number of fixed width to `to`, which must have room.
template <std::unsigned_integral Number>
void storeNumber(std::uint8_t* to, Number number) {
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(to, &number, sizeof number);
  } else {
    for (std::size_t i = 0; i < sizeof number; ++i) to[i] = static_cast<std::uint8_t>(number >> (8 * i));
  }
}

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

inline Bytes bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline std::string_view textOf(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Appends values to bytes, little-endian.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<std::uint8_t>& out) : out_(out) {}

  template <std::unsigned_integral Number>
  void put(Number number) {
    std::uint8_t bytes[sizeof number];
    storeNumber(bytes, number);
    out_.insert(out_.end(), bytes, bytes + sizeof number);
  }
  void put(Bytes bytes) { out_.insert(out_.end(), bytes.begin(), bytes.end()); }
  /// With its length in 32 bits before it.
  void put(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size()));
    put(bytesOf(text));
  }

 private:
  std::vector<std::uint8_t>& out_;
};

/// Takes values from bytes. What is asked for past the end is 0 or empty, and good() is false from then on.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  template <std::unsigned_integral Number>
  Number take() {
    const Bytes bytes = take(sizeof(Number));
    return bytes.empty() ? Number{0} : loadNumber<Number>(bytes.data());
  }
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
  /// With its length in 32 bits before it.
  std::string_view takeText() { return textOf(take(take<std::uint32_t>())); }

  bool good() const { return good_; }
  Bytes rest() const { return bytes_; }

 private:
  Bytes bytes_;
  bool good_ = true;
};

}  // namespace logplayer::mcap
