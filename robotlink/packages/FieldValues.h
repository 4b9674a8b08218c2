// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cstdint>
#include <string>

// Access to the fields of messages of any type, also of types that a file has described.
namespace robotlink {

/// The value of a field that has an enumeration; it need not be one of its enumerators.
struct EnumNumber {
  int number = 0;
};

/// Calls `visit` with the value of a field, as what it is: a number, a bool, an EnumNumber, a std::string or
/// a message. `element` is the index of a repeated field's element; negative for other fields.
template <typename Visit>
auto visitValue(const google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field,
                int element, Visit visit) {
  using google::protobuf::FieldDescriptor;
  using google::protobuf::Reflection;
  const Reflection& reflection = *message.GetReflection();
  const auto value = [&](auto single, auto repeated) {
    return element < 0 ? (reflection.*single)(message, &field)
                       : (reflection.*repeated)(message, &field, element);
  };
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return visit(value(&Reflection::GetInt32, &Reflection::GetRepeatedInt32));
    case FieldDescriptor::CPPTYPE_INT64:
      return visit(value(&Reflection::GetInt64, &Reflection::GetRepeatedInt64));
    case FieldDescriptor::CPPTYPE_UINT32:
      return visit(value(&Reflection::GetUInt32, &Reflection::GetRepeatedUInt32));
    case FieldDescriptor::CPPTYPE_UINT64:
      return visit(value(&Reflection::GetUInt64, &Reflection::GetRepeatedUInt64));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return visit(value(&Reflection::GetFloat, &Reflection::GetRepeatedFloat));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return visit(value(&Reflection::GetDouble, &Reflection::GetRepeatedDouble));
    case FieldDescriptor::CPPTYPE_BOOL:
      return visit(value(&Reflection::GetBool, &Reflection::GetRepeatedBool));
    case FieldDescriptor::CPPTYPE_ENUM:
      return visit(EnumNumber{value(&Reflection::GetEnumValue, &Reflection::GetRepeatedEnumValue)});
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return visit(element < 0 ? reflection.GetMessage(message, &field)
                               : reflection.GetRepeatedMessage(message, &field, element));
    case FieldDescriptor::CPPTYPE_STRING:
      break;
  }
  return visit(value(&Reflection::GetString, &Reflection::GetRepeatedString));
}

/// Whether a type is that of timestamps or durations, which have the same fields. A file may describe another
/// type under that name.
bool isTime(const google::protobuf::Descriptor& type);
/// The fields of such a message.
std::int64_t wholeSeconds(const google::protobuf::Message& time);
std::int32_t nanoseconds(const google::protobuf::Message& time);

}  // namespace robotlink
