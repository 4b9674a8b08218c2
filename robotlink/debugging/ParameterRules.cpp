// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ParameterRules.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cmath>
#include <cstdio>

namespace robotlink {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// The message that has the field itself; an empty one if it is not there.
const Message& ownerOf(const Message& message, const ParameterField& field) {
  const Message* owner = &message;
  for (std::size_t i = 0; i + 1 < field.path.size(); ++i)
    owner =
        &owner->GetReflection()->GetMessage(*owner, owner->GetDescriptor()->FindFieldByNumber(field.path[i]));
  return *owner;
}

Message& mutableOwnerOf(Message& message, const ParameterField& field) {
  Message* owner = &message;
  for (std::size_t i = 0; i + 1 < field.path.size(); ++i)
    owner = owner->GetReflection()->MutableMessage(owner,
                                                   owner->GetDescriptor()->FindFieldByNumber(field.path[i]));
  return *owner;
}

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

std::string ParameterRange::describe() const {
  const bool limited = std::isfinite(maximum);
  if (above) {
    return "more than " + numberText(minimum) + (limited ? " and at most " + numberText(maximum) : "");
  }
  if (limited) return "between " + numberText(minimum) + " and " + numberText(maximum);
  return "at least " + numberText(minimum);
}

std::optional<double> numberIn(const Message& message, const ParameterField& field) {
  const Message& owner = ownerOf(message, field);
  const FieldDescriptor* last = owner.GetDescriptor()->FindFieldByNumber(field.path.back());
  const google::protobuf::Reflection& reflection = *owner.GetReflection();
  if (last == nullptr || !reflection.HasField(owner, last)) return std::nullopt;
  switch (last->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return reflection.GetDouble(owner, last);
    case FieldDescriptor::CPPTYPE_INT32:
      return reflection.GetInt32(owner, last);
    case FieldDescriptor::CPPTYPE_UINT32:
      return reflection.GetUInt32(owner, last);
    default:
      return std::nullopt;
  }
}

void setNumber(Message& message, const ParameterField& field, double value) {
  Message& owner = mutableOwnerOf(message, field);
  const FieldDescriptor* last = owner.GetDescriptor()->FindFieldByNumber(field.path.back());
  const google::protobuf::Reflection& reflection = *owner.GetReflection();
  if (last->cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
    reflection.SetDouble(&owner, last, value);
  } else if (last->cpp_type() == FieldDescriptor::CPPTYPE_INT32) {
    reflection.SetInt32(&owner, last, static_cast<std::int32_t>(value));
  } else {
    reflection.SetUInt32(&owner, last, static_cast<std::uint32_t>(value));
  }
}

void clearNumber(Message& message, const ParameterField& field) {
  Message& owner = mutableOwnerOf(message, field);
  owner.GetReflection()->ClearField(&owner, owner.GetDescriptor()->FindFieldByNumber(field.path.back()));
}

std::string nameOf(const Message& message, const ParameterField& field) {
  std::string name;
  const google::protobuf::Descriptor* type = message.GetDescriptor();
  for (const int number : field.path) {
    const FieldDescriptor* described = type->FindFieldByNumber(number);
    name += (name.empty() ? "" : ".") + described->name();
    type = described->message_type();
  }
  return name;
}

}  // namespace robotlink
