// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ParameterRules.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cmath>
#include <cstdio>

namespace robotlink {
namespace {

using google::protobuf::FieldDescriptor;

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

std::optional<double> numberIn(const google::protobuf::Message& message, int field) {
  const FieldDescriptor* described = message.GetDescriptor()->FindFieldByNumber(field);
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  if (described == nullptr || !reflection.HasField(message, described)) return std::nullopt;
  if (described->cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE)
    return reflection.GetDouble(message, described);
  if (described->cpp_type() == FieldDescriptor::CPPTYPE_INT32) return reflection.GetInt32(message, described);
  return std::nullopt;
}

void setNumber(google::protobuf::Message& message, int field, double value) {
  const FieldDescriptor* described = message.GetDescriptor()->FindFieldByNumber(field);
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  if (described->cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
    reflection.SetDouble(&message, described, value);
  } else {
    reflection.SetInt32(&message, described, static_cast<std::int32_t>(value));
  }
}

}  // namespace robotlink
