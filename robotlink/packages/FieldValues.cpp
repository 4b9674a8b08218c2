// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/FieldValues.h"

namespace robotlink {

using google::protobuf::FieldDescriptor;

bool isTime(const google::protobuf::Descriptor& type) {
  if (type.full_name() != "google.protobuf.Timestamp" && type.full_name() != "google.protobuf.Duration")
    return false;
  const auto has = [&](int number, FieldDescriptor::CppType kind) {
    const FieldDescriptor* field = type.FindFieldByNumber(number);
    return field != nullptr && field->cpp_type() == kind && !field->is_repeated();
  };
  return has(1, FieldDescriptor::CPPTYPE_INT64) && has(2, FieldDescriptor::CPPTYPE_INT32);
}

std::int64_t wholeSeconds(const google::protobuf::Message& time) {
  return time.GetReflection()->GetInt64(time, time.GetDescriptor()->FindFieldByNumber(1));
}

std::int32_t nanoseconds(const google::protobuf::Message& time) {
  return time.GetReflection()->GetInt32(time, time.GetDescriptor()->FindFieldByNumber(2));
}

}  // namespace robotlink
