// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <string>

#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/bytes/ByteReader.h"

// How the structs of server packets are read and written. Each struct has one function, visitFields(packet,
// visitor), that calls visitor(name, member, unit) for its fields in the order of the wire. Readers, writers
// and descriptions are visitors, so the order of fields is defined in one place. Integers are little-endian
// and as wide as their type, strings end with a NUL. A list is visitor.size<CountType>(name, vector),
// followed by its elements between enter() and leave(); the field that numbers an element is a key().
//
// A unit may have a factor ("0.1 V", "1/4096 turn"), and be followed by names of values ("%; 0 unknown"). The
// unit of flags is "bits", or "bits: name, name" from bit 0 on.
//
// Internal to this folder.
namespace robotlink::arcos {

/// The visitor that reads fields from a packet's data. A missing required field makes ok() false; a missing
/// optional field ends the packet: it and all optional fields after it stay empty. The data must outlive it.
class FieldReader {
 public:
  explicit FieldReader(std::span<const std::uint8_t> data) : data_(data) {}

  /// Reads a required field.
  template <typename T>
  void operator()(const char* name, T& value, const char* = "") {
    if (!take(value)) fail(name);
  }
  /// Reads the number of an element.
  template <typename T>
  void key(const char* name, T& value) {
    (*this)(name, value);
  }
  /// Reads an optional field.
  template <typename T>
  void operator()(const char*, std::optional<T>& value, const char* = "") {
    T found{};
    ended_ = ended_ || !take(found);
    if (!ended_) value = std::move(found);
  }
  /// Reads the length of a list and resizes it. Every element has at least one byte, so a wrong length cannot
  /// use much memory.
  template <std::unsigned_integral Count, typename T>
  void size(const char* name, std::vector<T>& list) {
    Count count = 0;
    (*this)(name, count);
    if (count > data_.rest().size()) fail(name);
    if (ok_) list.resize(count);
  }
  /// The names of lists are only for missing().
  void enter(const char* list, std::size_t) { list_ = list; }
  void leave() {}
  /// Takes all remaining data.
  void rest(Bytes& bytes) {
    const auto all = data_.take(data_.rest().size());
    bytes.assign(all.begin(), all.end());
  }
  /// Takes exactly `count` bytes.
  void bytes(Bytes& taken, std::size_t count) {
    if (count > data_.rest().size()) fail("end");
    if (!ok_) return;
    const auto these = data_.take(count);
    taken.assign(these.begin(), these.end());
  }

  /// Whether all required fields were there so far.
  bool ok() const { return ok_; }
  /// The name of the first missing required field.
  const char* missing() const { return missing_; }

  /// Reads an integer, or a string up to its NUL. Returns false, reading nothing, if it is incomplete.
  template <std::integral T>
  bool take(T& value) {
    if (data_.rest().size() < sizeof(T)) return false;
    value = data_.take<T>();
    return true;
  }
  bool take(std::string& value) {
    const auto data = data_.rest();
    const auto end = std::find(data.begin(), data.end(), std::uint8_t{0});
    if (end == data.end()) return false;
    value.assign(data.begin(), end);
    data_.take(value.size() + 1);
    return true;
  }

 private:
  void fail(const char* name) {
    if (ok_) missing_ = *name == '\0' ? list_ : name;
    ok_ = false;
  }

  ByteReader data_;
  const char* missing_ = "";
  const char* list_ = "";
  bool ok_ = true;
  /// An optional field was missing.
  bool ended_ = false;
};

/// The visitor that appends fields to `data`; stops at the first empty optional field. The result is complete
/// after finish().
class FieldWriter {
 public:
  explicit FieldWriter(Bytes& data) : data_(data) {}
  FieldWriter(const FieldWriter&) = delete;
  FieldWriter& operator=(const FieldWriter&) = delete;

  /// Writes an integer.
  template <std::integral T>
  void operator()(const char*, const T& value, const char* = "") {
    if (used_ + sizeof(T) > buffer_.size()) finish();
    storeNumber(buffer_.data() + used_, value);
    used_ += sizeof(T);
  }
  /// Writes a string up to its first NUL, and a NUL.
  void operator()(const char* name, const std::string& value, const char* = "") {
    finish();
    data_.insert(data_.end(), value.begin(), std::find(value.begin(), value.end(), '\0'));
    (*this)(name, std::uint8_t{0});
  }
  /// Writes an optional field, unless it or one before it is empty.
  template <typename T>
  void operator()(const char* name, const std::optional<T>& value, const char* = "") {
    ended_ = ended_ || !value;
    if (!ended_) (*this)(name, *value);
  }
  template <typename T>
  void key(const char* name, const T& value) {
    (*this)(name, value);
  }
  /// Writes the length of a list, limited to the range of its type.
  template <std::unsigned_integral Count, typename T>
  void size(const char* name, const std::vector<T>& list) {
    (*this)(name, static_cast<Count>(std::min<std::size_t>(list.size(), std::numeric_limits<Count>::max())));
  }
  void enter(const char*, std::size_t) {}
  void leave() {}
  /// Writes the data after the known fields.
  void rest(const Bytes& bytes) {
    finish();
    data_.insert(data_.end(), bytes.begin(), bytes.end());
  }
  /// Writes exactly `count` bytes, padded with 0.
  void bytes(const Bytes& given, std::size_t count) {
    finish();
    const std::size_t there = std::min(count, given.size());
    data_.insert(data_.end(), given.begin(), given.begin() + static_cast<std::ptrdiff_t>(there));
    data_.insert(data_.end(), count - there, 0);
  }
  /// Appends the buffered integers to `data`.
  void finish() {
    data_.insert(data_.end(), buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(used_));
    used_ = 0;
  }

 private:
  Bytes& data_;
  /// Collects integers, so that data_ grows once for many fields.
  std::array<std::uint8_t, 256> buffer_;
  std::size_t used_ = 0;
  bool ended_ = false;
};

}  // namespace robotlink::arcos
