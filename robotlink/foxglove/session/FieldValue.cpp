// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/FieldValue.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "robotlink/base/Utf8.h"
#include "robotlink/packages/FieldValues.h"

namespace robotlink::websocket {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

bool isOffered(const FieldDescriptor& field) {
  return field.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE && field.type() != FieldDescriptor::TYPE_BYTES;
}

Value elementValue(const Message& message, const FieldDescriptor& field, int element) {
  return visitValue(message, field, element, [&](const auto& value) -> Value {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<T, EnumNumber>) {
      const auto* known = field.enum_type()->FindValueByNumber(value.number);
      return {known != nullptr ? known->name() : std::to_string(value.number)};
    } else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>) {
      return {value};
    } else if constexpr (std::is_floating_point_v<T>) {
      return {static_cast<double>(value)};
    } else if constexpr (std::is_integral_v<T>) {
      return {static_cast<std::int64_t>(value)};
    } else {
      return {std::string()};  // a message; isOffered() keeps them away
    }
  });
}

std::optional<double> asNumber(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  return std::nullopt;
}

/// A whole number of a type, which may be written as 3.0.
template <typename Number>
std::optional<Number> asWhole(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.data))
    return std::in_range<Number>(*whole) ? std::optional(static_cast<Number>(*whole)) : std::nullopt;
  const auto* number = std::get_if<double>(&value.data);
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (number == nullptr || std::abs(*number) > kExact || std::floor(*number) != *number) return std::nullopt;
  return asWhole<Number>(Value{static_cast<std::int64_t>(*number)});
}

/// Sets a field, or adds an element to it.
struct Setter {
  Message& message;
  const FieldDescriptor& field;

  template <typename T, typename Set, typename Add>
  std::string put(const std::optional<T>& value, Set set, Add add, const char* wanted) const {
    if (!value) return wanted;
    const Reflection& reflection = *message.GetReflection();
    (reflection.*(field.is_repeated() ? add : set))(&message, &field, *value);
    return {};
  }
  std::string put(const Value& value) const;
  std::string putText(const Value& value) const;
  std::string putName(const Value& value) const;
};

std::string Setter::putText(const Value& value) const {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr || validUtf8(*text) != *text) return "is a text";
  const Reflection& reflection = *message.GetReflection();
  field.is_repeated() ? reflection.AddString(&message, &field, *text)
                      : reflection.SetString(&message, &field, *text);
  return {};
}

std::string Setter::putName(const Value& value) const {
  const auto* name = std::get_if<std::string>(&value.data);
  const auto* known = name == nullptr ? nullptr : field.enum_type()->FindValueByName(*name);
  if (known == nullptr) {
    std::string names;
    for (int i = 0; i < field.enum_type()->value_count(); ++i)
      names += (i > 0 ? ", " : "") + field.enum_type()->value(i)->name();
    return "is one of " + names;
  }
  const Reflection& reflection = *message.GetReflection();
  field.is_repeated() ? reflection.AddEnum(&message, &field, known)
                      : reflection.SetEnum(&message, &field, known);
  return {};
}

std::string Setter::put(const Value& value) const {
  using R = Reflection;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return put(asNumber(value), &R::SetDouble, &R::AddDouble, "is a number");
    case FieldDescriptor::CPPTYPE_FLOAT: {
      const auto number = asNumber(value);
      const bool fits = number && std::abs(*number) <= std::numeric_limits<float>::max();
      return put(fits ? std::optional(static_cast<float>(*number)) : std::nullopt, &R::SetFloat, &R::AddFloat,
                 "is a number");
    }
    case FieldDescriptor::CPPTYPE_INT32:
      return put(asWhole<std::int32_t>(value), &R::SetInt32, &R::AddInt32, "is a whole number");
    case FieldDescriptor::CPPTYPE_INT64:
      return put(asWhole<std::int64_t>(value), &R::SetInt64, &R::AddInt64, "is a whole number");
    case FieldDescriptor::CPPTYPE_UINT32:
      return put(asWhole<std::uint32_t>(value), &R::SetUInt32, &R::AddUInt32, "is a whole number from 0");
    case FieldDescriptor::CPPTYPE_UINT64:
      return put(asWhole<std::uint64_t>(value), &R::SetUInt64, &R::AddUInt64, "is a whole number from 0");
    case FieldDescriptor::CPPTYPE_BOOL: {
      const auto* flag = std::get_if<bool>(&value.data);
      return put(flag != nullptr ? std::optional(*flag) : std::nullopt, &R::SetBool, &R::AddBool,
                 "is true or false");
    }
    case FieldDescriptor::CPPTYPE_ENUM:
      return putName(value);
    default:
      return putText(value);
  }
}

}  // namespace

std::optional<Value> fieldValue(const Message& message, const FieldDescriptor& field) {
  if (!isOffered(field)) return std::nullopt;
  if (!field.is_repeated()) return elementValue(message, field, -1);
  Value::Array array;
  for (int i = 0; i < message.GetReflection()->FieldSize(message, &field); ++i)
    array.push_back(elementValue(message, field, i));
  return Value{std::move(array)};
}

std::string setFieldValue(Message& message, const FieldDescriptor& field, const Value& value) {
  if (!isOffered(field)) return "cannot be set";
  if (!field.is_repeated()) return Setter{message, field}.put(value);
  const auto* array = std::get_if<Value::Array>(&value.data);
  if (array == nullptr) return "is a list";
  const std::unique_ptr<Message> changed(message.New());
  for (const Value& element : *array) {
    if (std::string wrong = Setter{*changed, field}.put(element); !wrong.empty())
      return "is a list, of which each element " + wrong;
  }
  changed->GetReflection()->SwapFields(changed.get(), &message, {&field});
  return {};
}

}  // namespace robotlink::websocket
