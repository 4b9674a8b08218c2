// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/decoding/JsonValues.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/decoding/JsonText.h"
#include "robotlink/packages/FieldValues.h"

namespace robotlink {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using nlohmann::json;

namespace {

template <typename Number>
std::optional<Number> integerOf(const json& value) {
  using Limits = std::numeric_limits<Number>;
  if (value.is_number_unsigned()) {
    const auto number = value.get<std::uint64_t>();
    return number <= static_cast<std::uint64_t>(Limits::max()) ? std::optional(static_cast<Number>(number))
                                                               : std::nullopt;
  }
  if (value.is_number_integer()) {
    const auto number = value.get<std::int64_t>();
    const bool fits = std::in_range<Number>(number);
    return fits ? std::optional(static_cast<Number>(number)) : std::nullopt;
  }
  if (value.is_number_float()) {
    const auto number = value.get<double>();
    // 2^53: beyond it not every integer is exact.
    constexpr double kExact = 9007199254740992.0;
    const bool whole = std::abs(number) <= kExact && std::trunc(number) == number;
    return whole && std::in_range<Number>(static_cast<std::int64_t>(number))
               ? std::optional(static_cast<Number>(static_cast<std::int64_t>(number)))
               : std::nullopt;
  }
  if (!value.is_string()) return std::nullopt;  // 64-bit integers are often written as strings
  return robotlink::parsedNumber<Number>(value.get_ref<const std::string&>());
}

/// JSON has no infinite numbers: null often means NaN, and some programs write names.
std::optional<double> numberOf(const json& value) {
  if (value.is_number()) return value.get<double>();
  if (value.is_null() || value == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (value == "Infinity") return std::numeric_limits<double>::infinity();
  if (value == "-Infinity") return -std::numeric_limits<double>::infinity();
  return std::nullopt;
}

const json* memberOf(const json& object, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (const auto found = object.find(key); found != object.end()) return &*found;
  }
  return nullptr;
}

/// Assigns an object with exactly the members sec and nsec.
bool assignTime(Message& to, const json& value) {
  const auto* seconds = to.GetDescriptor()->FindFieldByNumber(1);
  const auto* nanos = to.GetDescriptor()->FindFieldByNumber(2);
  if (!value.is_object() || value.size() != 2) return false;
  const json* whole = memberOf(value, {"sec", "seconds"});
  const json* rest = memberOf(value, {"nsec", "nanosec", "nanos"});
  const auto s = whole != nullptr ? integerOf<std::int64_t>(*whole) : std::nullopt;
  const auto ns = rest != nullptr ? integerOf<std::int32_t>(*rest) : std::nullopt;
  if (!s || !ns || *ns < 0 || *ns >= 1'000'000'000) return false;
  to.GetReflection()->SetInt64(&to, seconds, *s);
  to.GetReflection()->SetInt32(&to, nanos, *ns);
  return true;
}

/// Assigns one object to one message.
class Assignment {
 public:
  Assignment(const JsonFields& fields, json& others) : fields_(fields), others_(others) {}

  void assign(Message& to, const json& object, const std::string& path) {
    const auto known = fields_.find(to.GetDescriptor());
    for (const auto& [property, value] : object.items()) {
      const std::string where = path.empty() ? property : path + "." + property;
      const FieldDescriptor* field = nullptr;
      if (known != fields_.end()) {
        const auto found = known->second.find(property);
        if (found != known->second.end()) field = found->second;
      }
      if (field != nullptr && (field->is_repeated() ? assignAll(to, *field, value, where)
                                                    : assignOne(to, *field, value, where))) {
        continue;
      }
      others_[where] = value;
      if (field != nullptr) to.GetReflection()->ClearField(&to, field);
    }
  }

 private:
  bool assignAll(Message& to, const FieldDescriptor& field, const json& values, const std::string& path) {
    if (values.is_null()) return true;
    if (!values.is_array()) return false;
    std::size_t index = 0;
    for (const json& value : values) {
      if (!add(to, field, value, path + "[" + std::to_string(index++) + "]")) return false;
    }
    return true;
  }
  bool assignOne(Message& to, const FieldDescriptor& field, const json& value, const std::string& path) {
    return value.is_null() || add(to, field, value, path);
  }
  bool add(Message& to, const FieldDescriptor& field, const json& value, const std::string& path);
  bool addMessage(Message& to, const FieldDescriptor& field, const json& value, const std::string& path);
  static bool addText(Message& to, const FieldDescriptor& field, const json& value);
  static bool addEnum(Message& to, const FieldDescriptor& field, const json& value);

  const JsonFields& fields_;
  json& others_;
};

/// Sets or appends a value of a plain type; does nothing without a value.
template <typename Value, typename Field>
bool put(Message& to, const FieldDescriptor& field, const std::optional<Value>& value,
         void (Reflection::*set)(Message*, const FieldDescriptor*, Field) const,
         void (Reflection::*append)(Message*, const FieldDescriptor*, Field) const) {
  if (!value) return false;
  (to.GetReflection()->*(field.is_repeated() ? append : set))(&to, &field, static_cast<Field>(*value));
  return true;
}

bool Assignment::add(Message& to, const FieldDescriptor& field, const json& value, const std::string& path) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return put(to, field, numberOf(value), &Reflection::SetDouble, &Reflection::AddDouble);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return put(to, field, numberOf(value), &Reflection::SetFloat, &Reflection::AddFloat);
    case FieldDescriptor::CPPTYPE_INT32:
      return put(to, field, integerOf<std::int32_t>(value), &Reflection::SetInt32, &Reflection::AddInt32);
    case FieldDescriptor::CPPTYPE_INT64:
      return put(to, field, integerOf<std::int64_t>(value), &Reflection::SetInt64, &Reflection::AddInt64);
    case FieldDescriptor::CPPTYPE_UINT32:
      return put(to, field, integerOf<std::uint32_t>(value), &Reflection::SetUInt32, &Reflection::AddUInt32);
    case FieldDescriptor::CPPTYPE_UINT64:
      return put(to, field, integerOf<std::uint64_t>(value), &Reflection::SetUInt64, &Reflection::AddUInt64);
    case FieldDescriptor::CPPTYPE_BOOL:
      return put(to, field, value.is_boolean() ? std::optional(value.get<bool>()) : std::nullopt,
                 &Reflection::SetBool, &Reflection::AddBool);
    case FieldDescriptor::CPPTYPE_ENUM:
      return addEnum(to, field, value);
    case FieldDescriptor::CPPTYPE_STRING:
      return addText(to, field, value);
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return addMessage(to, field, value, path);
  }
  return false;
}

bool Assignment::addEnum(Message& to, const FieldDescriptor& field, const json& value) {
  std::optional<int> number = integerOf<std::int32_t>(value);
  if (value.is_string()) {
    const auto* named = field.enum_type()->FindValueByName(value.get<std::string>());
    if (named != nullptr) number = named->number();
  }
  return put(to, field, number, &Reflection::SetEnumValue, &Reflection::AddEnumValue);
}

/// A text field accepts any JSON; values other than strings are stored as JSON text.
bool Assignment::addText(Message& to, const FieldDescriptor& field, const json& value) {
  std::optional<std::string> text;
  if (field.type() == FieldDescriptor::TYPE_BYTES) {
    if (value.is_string()) text = decodeBase64(value.get_ref<const std::string&>());
  } else {
    text = value.is_string() ? value.get<std::string>() : jsonText(value);
  }
  if (!text) return false;
  const Reflection* reflection = to.GetReflection();
  if (field.is_repeated()) {
    reflection->AddString(&to, &field, std::move(*text));
  } else {
    reflection->SetString(&to, &field, std::move(*text));
  }
  return true;
}

bool Assignment::addMessage(Message& to, const FieldDescriptor& field, const json& value,
                            const std::string& path) {
  const Reflection* reflection = to.GetReflection();
  Message& inner =
      field.is_repeated() ? *reflection->AddMessage(&to, &field) : *reflection->MutableMessage(&to, &field);
  const Descriptor& type = *inner.GetDescriptor();
  if (robotlink::isTime(type)) return assignTime(inner, value);
  // Only rows of arrays of arrays are arrays.
  const bool row = type.field_count() == 1 && type.field(0)->is_repeated() && !fields_.contains(&type);
  if (row) return value.is_array() && assignAll(inner, *type.field(0), value, path);
  if (!value.is_object()) return false;
  assign(inner, value, path);
  return true;
}

}  // namespace

void assignJson(Message& to, const json& object, const JsonFields& fields, json& others) {
  Assignment(fields, others).assign(to, object, {});
}

}  // namespace robotlink
