// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/base/bytes/ByteWriter.h"

namespace simcore {

/// Writes the state of a simulation to bytes, or reads it from there: a class has one function for both
/// (transfer()), so that the two cannot differ. Numbers are little-endian and keep all of their bits.
///
/// Reading never trusts what it reads: after the first value that is missing or out of its range good() is
/// false, values are left as they are, and sizes are 0. Only what this program has written itself before need
/// not be within ranges (Trust::kOwn), since a simulation may have blown up. One thread at a time.
class StateStream {
 public:
  enum class Trust : std::uint8_t { kOwn, kForeign };
  /// No coordinate, velocity or other number of a simulation is larger; SI units.
  static constexpr double kMaxNumber = 1e7;

  /// Writes; `out` must outlive it.
  explicit StateStream(std::vector<std::uint8_t>& out) : writer_(out), reader_({}), isReading_(false) {}
  /// Reads; `in` must outlive it.
  StateStream(std::span<const std::uint8_t> in, Trust trust)
      : writer_(unused_), reader_(in), isReading_(true), isForeign_(trust == Trust::kForeign) {}
  StateStream(const StateStream&) = delete;
  StateStream& operator=(const StateStream&) = delete;

  bool isReading() const { return isReading_; }
  bool good() const { return good_ && reader_.good(); }
  /// Whether everything was read that there is.
  bool complete() const { return good() && reader_.complete(); }
  /// Marks a state that was read as invalid unless `holds`. Has no effect on a state of this program.
  void require(bool holds) {
    if (isReading_ && isForeign_ && !holds) good_ = false;
  }
  /// Marks the state that was read as invalid.
  void fail() { good_ = false; }

  /// A number of fixed width, of any value.
  template <robotlink::FixedWidth Number>
  void raw(Number& value) {
    if (!isReading_) return writer_.put(value);
    const auto read = reader_.take<Number>();
    if (good()) value = read;
  }
  void flag(bool& value) {
    auto byte = static_cast<std::uint8_t>(value ? 1 : 0);
    raw(byte);
    require(byte <= 1);
    if (good()) value = byte != 0;
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void choice(Enum& value, Enum last) {
    auto byte = static_cast<std::uint8_t>(value);
    raw(byte);
    if (byte > static_cast<std::uint8_t>(last)) return fail();
    value = static_cast<Enum>(byte);
  }
  /// A finite number of at most kMaxNumber.
  void number(double& value) { within(value, -kMaxNumber, kMaxNumber); }
  /// A number of a range, both ends included.
  void within(double& value, double low, double high) {
    double read = value;
    raw(read);
    require(read >= low && read <= high);
    if (good()) value = read;
  }
  /// Integers of 0 up to and including `most`.
  template <std::unsigned_integral Number>
  void upTo(Number& value, Number most) {
    Number read = value;
    raw(read);
    require(read <= most);
    if (good()) value = read;
  }
  void vector(robotlink::Vector3& value) {
    for (int i = 0; i < 3; ++i) number(value[i]);
  }
  void pose(robotlink::Pose2& value) {
    number(value.x);
    number(value.y);
    number(value.heading);
  }
  void pose(robotlink::Pose3& value) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) number(value.matrix()(row, column));
    }
  }
  void text(std::string& value) {
    if (!isReading_) return writer_.put(std::string_view(value));
    const auto read = reader_.takeText();
    if (good()) value = read;
  }
  void bits(std::vector<bool>& value) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      bool bit = value[i];
      flag(bit);
      value[i] = bit;
    }
  }
  /// The size of a container, at most `most`, which gets this size; 0 where it cannot be read. Each element
  /// takes at least a byte.
  template <typename Container>
  void size(Container& container, std::size_t most) {
    auto count = static_cast<std::uint32_t>(container.size());
    raw(count);
    if (!isReading_) return;
    if (count > most || count > reader_.rest().size()) fail();
    container.resize(good() ? count : 0);
  }

 private:
  std::vector<std::uint8_t> unused_;
  robotlink::ByteWriter writer_;
  robotlink::ByteReader reader_;
  bool isReading_, isForeign_ = false, good_ = true;
};

}  // namespace simcore
