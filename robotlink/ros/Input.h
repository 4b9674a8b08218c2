// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "robotlink/base/Error.h"

namespace robotlink::ros {

/// The encoding of a sequence of values.
struct Encoding {
  /// Whether numbers are big-endian.
  bool isBigEndian = false;
  /// The maximum alignment: numbers are aligned to their size, up to this. 1: not at all.
  std::size_t alignment = 1;
  /// Whether texts end with a NUL, which their length includes; structs without fields have one byte; seconds
  /// are signed and nanoseconds are not.
  bool isRos2 = false;
  /// Whether the values of arrays and sequences that are no numbers follow their size in bytes.
  bool hasSizes = false;
  /// The bytes of a character of a wide text.
  std::size_t wideBytes = 4;
  /// Whether the length of a wide text counts bytes rather than characters.
  bool countsWideBytes = false;
};

/// The bytes of a message, whose lengths are not trusted. The first failure is kept: from then on nothing
/// more is read.
class Input {
 public:
  /// `begin`: where the values begin, from which alignment counts.
  Input(std::span<const std::uint8_t> bytes, std::size_t begin, const Encoding& encoding)
      : bytes_(bytes), begin_(begin), at_(begin), encoding_(encoding) {}

  const Encoding& encoding() const { return encoding_; }
  std::size_t rest() const { return bytes_.size() - at_; }
  /// Whether numbers are in the order of this machine.
  bool isNative() const { return encoding_.isBigEndian == (std::endian::native == std::endian::big); }

  /// Skips the padding in front of a number of `size` bytes.
  void align(std::size_t size) {
    const std::size_t mask = std::min(size, encoding_.alignment) - 1;
    at_ = std::min(bytes_.size(), begin_ + ((at_ - begin_ + mask) & ~mask));
  }
  /// Takes `count` bytes; null if there are fewer.
  const std::uint8_t* take(std::uint64_t count) {
    if (count > rest()) return nullptr;
    const std::uint8_t* taken = bytes_.data() + at_;
    at_ += static_cast<std::size_t>(count);
    return taken;
  }
  template <typename Number>
  bool number(Number& to) {
    align(sizeof(Number));
    const std::uint8_t* from = take(sizeof(Number));
    if (from == nullptr) return fail("the message ends within a number");
    to = load<Number>(from);
    return true;
  }
  template <typename Number>
  Number load(const std::uint8_t* from) const {
    std::array<std::uint8_t, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), from, sizeof(Number));
    if (!isNative()) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
  }

  /// Returns false.
  bool fail(const char* problem) {
    if (problem_ == nullptr) {
      problem_ = problem;
      problemAt_ = at_;
    }
    return false;
  }
  /// Returns the problem with its position.
  Error error() const {
    const std::string place = std::to_string(problemAt_);
    return {"ros.message", "at byte " + place + ": " + (problem_ != nullptr ? problem_ : ""), {place}, {}};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t begin_, at_;
  Encoding encoding_;
  const char* problem_ = nullptr;
  std::size_t problemAt_ = 0;
};

}  // namespace robotlink::ros
