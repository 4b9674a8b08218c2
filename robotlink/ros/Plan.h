// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/ros/Definition.h"

namespace google::protobuf {
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

namespace robotlink::ros {

struct StructPlan;

/// How the bytes of one field are read, and into what.
struct FieldPlan {
  const google::protobuf::FieldDescriptor* field = nullptr;
  Kind kind = Kind::kStruct;
  Shape shape = Shape::kSingle;
  /// The count of Field.
  std::uint64_t count = 0;
  /// The plan of a field that is a struct.
  const StructPlan* inner = nullptr;
  /// For a field that is a struct or a time, a message to make others like it.
  const google::protobuf::Message* prototype = nullptr;
  bool isEnumeration = false;
  /// The fewest bytes that one value takes.
  std::uint64_t leastBytes = 0;
};

/// How a struct is read: field by field.
struct StructPlan {
  std::vector<FieldPlan> fields;
  /// The fewest bytes that it takes, without padding.
  std::uint64_t leastBytes = 0;
};

}  // namespace robotlink::ros
