// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/Decoder.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "robotlink/base/Utf8.h"
#include "robotlink/ros/Input.h"

namespace robotlink::ros {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using google::protobuf::RepeatedField;

namespace {

/// Structs without bytes of their own that a message may have in addition to one for each byte.
constexpr std::uint64_t kSpareStructs = 10'000;
/// The maximum number of elements of a repeated field.
constexpr std::uint64_t kMaxValues = std::numeric_limits<int>::max();
constexpr std::int64_t kNanosPerSecond = 1'000'000'000;

/// The values of a repeated field. Protobuf advises against it, but offers nothing else that is filled at
/// once rather than by one virtual call for each value.
template <typename Value>
RepeatedField<Value>& valuesOf(Message& message, const FieldDescriptor* field) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  return *message.GetReflection()->MutableRepeatedField<Value>(&message, field);
#pragma GCC diagnostic pop
}

/// Sets or appends a message within one. Protobuf's own functions look its type up each time.
Message& addMessage(const FieldPlan& plan, Message& to) {
  Message* inner = plan.prototype->New(to.GetArena());
  if (plan.shape == Shape::kSingle)
    to.GetReflection()->UnsafeArenaSetAllocatedMessage(&to, inner, plan.field);
  else
    to.GetReflection()->UnsafeArenaAddAllocatedMessage(&to, plan.field, inner);
  return *inner;
}

void appendUtf8(std::string& to, std::uint32_t c) {
  const auto add = [&](std::uint32_t byte) { to += static_cast<char>(byte); };
  if (c < 0x80) return add(c);
  if (c < 0x800) {
    add(0xC0 | (c >> 6));
  } else {
    if (c < 0x10000) {
      add(0xE0 | (c >> 12));
    } else {
      add(0xF0 | (c >> 18));
      add(0x80 | ((c >> 12) & 0x3F));
    }
    add(0x80 | ((c >> 6) & 0x3F));
  }
  add(0x80 | (c & 0x3F));
}

/// Collects the characters of UTF-16 or UTF-32; anything else becomes "?".
class WideText {
 public:
  void add(std::uint32_t unit) {
    if (high_ != 0 && unit >= 0xDC00 && unit < 0xE000) {
      appendUtf8(text_, 0x10000 + ((high_ - 0xD800) << 10) + (unit - 0xDC00));
      high_ = 0;
      return;
    }
    end();
    if (unit >= 0xD800 && unit < 0xDC00)
      high_ = unit;
    else if (unit > 0x10FFFF || (unit >= 0xDC00 && unit < 0xE000))
      text_ += '?';
    else
      appendUtf8(text_, unit);
  }
  std::string take() {
    end();
    return std::move(text_);
  }

 private:
  void end() {
    if (std::exchange(high_, 0) != 0) text_ += '?';
  }
  std::string text_;
  std::uint32_t high_ = 0;
};

class Decoder {
 public:
  explicit Decoder(Input& input) : in_(input), structsLeft_(input.rest() + kSpareStructs) {}
  bool readStruct(const StructPlan& plan, Message& to);

 private:
  bool readOne(const FieldPlan& plan, Message& to);
  bool readAll(const FieldPlan& plan, Message& to);
  bool readValues(const FieldPlan& plan, std::uint64_t count, Message& to);
  bool readTime(const FieldPlan& plan, Message& to);
  bool readText(Kind kind, std::string& to);
  bool readWideText(std::string& to);
  bool readInner(const FieldPlan& plan, Message& to);

  template <typename Wire, typename Value>
  bool set(const FieldPlan& plan, Message& to,
           void (Reflection::*setter)(Message*, const FieldDescriptor*, Value) const) {
    Wire number{};
    if (!in_.number(number)) return false;
    const Reflection& reflection = *to.GetReflection();
    if (plan.isEnumeration)
      reflection.SetEnumValue(&to, plan.field, static_cast<int>(number));
    else
      (reflection.*setter)(&to, plan.field, static_cast<Value>(number));
    return true;
  }
  template <typename Wire, typename Value = Wire>
  bool append(const FieldPlan& plan, std::uint64_t count, Message& to);

  Input& in_;
  std::uint64_t structsLeft_;
};

bool Decoder::readStruct(const StructPlan& plan, Message& to) {
  for (const FieldPlan& field : plan.fields) {
    if (!(field.shape == Shape::kSingle ? readOne(field, to) : readAll(field, to))) return false;
  }
  // Missing at the end of a message, it is no loss.
  if (plan.fields.empty() && in_.encoding().isRos2) (void)in_.take(1);
  return true;
}

bool Decoder::readOne(const FieldPlan& plan, Message& to) {
  switch (plan.kind) {
    case Kind::kBool:
      return set<std::uint8_t>(plan, to, &Reflection::SetBool);
    case Kind::kInt8:
      return set<std::int8_t>(plan, to, &Reflection::SetInt32);
    case Kind::kUint8:
      return set<std::uint8_t>(plan, to, &Reflection::SetUInt32);
    case Kind::kInt16:
      return set<std::int16_t>(plan, to, &Reflection::SetInt32);
    case Kind::kUint16:
      return set<std::uint16_t>(plan, to, &Reflection::SetUInt32);
    case Kind::kInt32:
      return set<std::int32_t>(plan, to, &Reflection::SetInt32);
    case Kind::kUint32:
      return set<std::uint32_t>(plan, to, &Reflection::SetUInt32);
    case Kind::kInt64:
      return set<std::int64_t>(plan, to, &Reflection::SetInt64);
    case Kind::kUint64:
      return set<std::uint64_t>(plan, to, &Reflection::SetUInt64);
    case Kind::kFloat32:
      return set<float>(plan, to, &Reflection::SetFloat);
    case Kind::kFloat64:
      return set<double>(plan, to, &Reflection::SetDouble);
    case Kind::kString:
    case Kind::kWstring: {
      std::string text;
      if (!readText(plan.kind, text)) return false;
      to.GetReflection()->SetString(&to, plan.field, std::move(text));
      return true;
    }
    case Kind::kTime:
    case Kind::kDuration:
      return readTime(plan, addMessage(plan, to));
    case Kind::kStruct:
      break;
  }
  return readInner(plan, addMessage(plan, to));
}

bool Decoder::readAll(const FieldPlan& plan, Message& to) {
  const bool isNumber = plan.kind < Kind::kString;
  if (std::uint32_t bytes = 0; in_.encoding().hasSizes && !isNumber && !in_.number(bytes)) return false;
  std::uint64_t count = plan.count;
  if (plan.shape == Shape::kSequence) {
    std::uint32_t sent = 0;
    if (!in_.number(sent)) return false;
    if (plan.count > 0 && sent > plan.count)
      return in_.fail("there are more values than the definition allows");
    count = sent;
  }
  if (count > kMaxValues || (plan.leastBytes > 0 && count > in_.rest() / plan.leastBytes))
    return in_.fail("there are more values than the message has room for");
  if (count == 0) return true;
  return readValues(plan, count, to);
}

/// Numbers whose bytes are as in memory are copied at once.
template <typename Wire, typename Value>
bool Decoder::append(const FieldPlan& plan, std::uint64_t count, Message& to) {
  in_.align(sizeof(Wire));
  const std::uint8_t* from = in_.take(count * sizeof(Wire));
  if (from == nullptr) return in_.fail("the message ends within a list of numbers");
  RepeatedField<Value>& values = valuesOf<Value>(to, plan.field);
  values.Reserve(static_cast<int>(count));
  Value* next = values.AddNAlreadyReserved(static_cast<int>(count));
  if constexpr (std::is_same_v<Wire, Value>) {
    if (in_.isNative()) {
      std::memcpy(next, from, count * sizeof(Wire));
      return true;
    }
  }
  for (std::uint64_t i = 0; i < count; ++i, from += sizeof(Wire))
    *next++ = static_cast<Value>(in_.load<Wire>(from));
  return true;
}

bool Decoder::readValues(const FieldPlan& plan, std::uint64_t count, Message& to) {
  switch (plan.kind) {
    case Kind::kBool:
      return append<std::uint8_t, bool>(plan, count, to);
    case Kind::kInt8:
      return append<std::int8_t, std::int32_t>(plan, count, to);
    case Kind::kUint8: {
      const auto* bytes = reinterpret_cast<const char*>(in_.take(count));
      if (bytes == nullptr) return in_.fail("the message ends within a list of bytes");
      to.GetReflection()->SetString(&to, plan.field, std::string(bytes, count));
      return true;
    }
    case Kind::kInt16:
      return append<std::int16_t, std::int32_t>(plan, count, to);
    case Kind::kUint16:
      return append<std::uint16_t, std::uint32_t>(plan, count, to);
    case Kind::kInt32:
      return append<std::int32_t>(plan, count, to);
    case Kind::kUint32:
      return append<std::uint32_t>(plan, count, to);
    case Kind::kInt64:
      return append<std::int64_t>(plan, count, to);
    case Kind::kUint64:
      return append<std::uint64_t>(plan, count, to);
    case Kind::kFloat32:
      return append<float>(plan, count, to);
    case Kind::kFloat64:
      return append<double>(plan, count, to);
    case Kind::kString:
    case Kind::kWstring:
    case Kind::kTime:
    case Kind::kDuration:
    case Kind::kStruct:
      break;
  }
  const Reflection& reflection = *to.GetReflection();
  for (std::uint64_t i = 0; i < count; ++i) {
    if (plan.kind == Kind::kString || plan.kind == Kind::kWstring) {
      std::string text;
      if (!readText(plan.kind, text)) return false;
      reflection.AddString(&to, plan.field, std::move(text));
      continue;
    }
    Message& inner = addMessage(plan, to);
    if (!(plan.kind == Kind::kStruct ? readInner(plan, inner) : readTime(plan, inner))) return false;
  }
  return true;
}

bool Decoder::readInner(const FieldPlan& plan, Message& to) {
  if (structsLeft_-- == 0) return in_.fail("there are more parts than a message of this size can hold");
  return readStruct(*plan.inner, to);
}

/// Nanoseconds beyond a second are carried; in a duration they have the sign of its seconds.
bool Decoder::readTime(const FieldPlan& plan, Message& to) {
  std::uint32_t whole = 0, rest = 0;
  if (!in_.number(whole) || !in_.number(rest)) return false;
  const auto value = [](std::uint32_t bits, bool isSigned) {
    return isSigned ? std::int64_t{static_cast<std::int32_t>(bits)} : std::int64_t{bits};
  };
  const bool isDuration = plan.kind == Kind::kDuration, isRos2 = in_.encoding().isRos2;
  std::int64_t seconds = value(whole, isDuration || isRos2);
  std::int64_t nanos = value(rest, isDuration && !isRos2);
  seconds += nanos / kNanosPerSecond;
  nanos %= kNanosPerSecond;
  if (isDuration && seconds > 0 && nanos < 0) {
    --seconds;
    nanos += kNanosPerSecond;
  } else if (isDuration && seconds < 0 && nanos > 0) {
    ++seconds;
    nanos -= kNanosPerSecond;
  }
  const Reflection& reflection = *to.GetReflection();
  reflection.SetInt64(&to, to.GetDescriptor()->field(0), seconds);
  reflection.SetInt32(&to, to.GetDescriptor()->field(1), static_cast<std::int32_t>(nanos));
  return true;
}

bool Decoder::readText(Kind kind, std::string& to) {
  if (kind == Kind::kWstring) return readWideText(to);
  std::uint32_t length = 0;
  if (!in_.number(length)) return false;
  const auto* text = reinterpret_cast<const char*>(in_.take(length));
  if (text == nullptr) return in_.fail("a text is longer than the message");
  if (in_.encoding().isRos2 && length > 0 && text[length - 1] == '\0') --length;
  to = validUtf8(std::string(text, length));
  return true;
}

bool Decoder::readWideText(std::string& to) {
  const std::size_t size = in_.encoding().wideBytes;
  std::uint32_t length = 0;
  if (!in_.number(length)) return false;
  const std::uint64_t count = in_.encoding().countsWideBytes ? length / size : length;
  const std::uint8_t* from = in_.take(count * size);
  if (from == nullptr) return in_.fail("a text is longer than the message");
  WideText text;
  for (std::uint64_t i = 0; i < count; ++i, from += size)
    text.add(size == 2 ? in_.load<std::uint16_t>(from) : in_.load<std::uint32_t>(from));
  to = text.take();
  return true;
}

Result<void> decode(Input input, const StructPlan& plan, Message& to) {
  if (Decoder(input).readStruct(plan, to)) return {};
  return tl::unexpected(input.error());
}

/// The encodings that the second byte of a message names (RTPS 2.5, table 10.3; DDS-XTypes 1.3 had other
/// numbers for XCDR2).
std::optional<Encoding> cdrEncoding(std::uint8_t number) {
  constexpr Encoding kXcdr1{.alignment = 8, .isRos2 = true};
  constexpr Encoding kXcdr2{
      .alignment = 4, .isRos2 = true, .hasSizes = true, .wideBytes = 2, .countsWideBytes = true};
  std::optional<Encoding> encoding;
  if (number <= 1) encoding = kXcdr1;
  if (number == 6 || number == 7 || number == 0x10 || number == 0x11) encoding = kXcdr2;
  if (encoding) encoding->isBigEndian = number % 2 == 0;
  return encoding;
}

}  // namespace

Result<void> decodeCdr(std::span<const std::uint8_t> data, const StructPlan& plan, Message& to) {
  constexpr std::size_t kHeader = 4;
  if (data.size() < kHeader)
    return failure("ros.message", "the message is shorter than the header of CDR, which has 4 bytes");
  const auto encoding = data[0] == 0 ? cdrEncoding(data[1]) : std::nullopt;
  if (!encoding) {
    const std::string number = std::to_string(data[0] * 256 + data[1]);
    return failure("ros.message", "CDR of kind " + number + " is not read, only plain XCDR1 and XCDR2", {},
                   {number});
  }
  return decode(Input(data, kHeader, *encoding), plan, to);
}

Result<void> decodeRos1(std::span<const std::uint8_t> data, const StructPlan& plan, Message& to) {
  return decode(Input(data, 0, Encoding{}), plan, to);
}

}  // namespace robotlink::ros
