// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <string>
#include <vector>

namespace google::protobuf {
class Timestamp;
}
namespace foxglove {
class Pose;
class Quaternion;
class Vector3;
}  // namespace foxglove

namespace robotlink::ros {

/// Access to a message's fields by their names. Missing fields, and those of another type, are 0 or empty: a
/// definition may call anything sensor_msgs/Image. The message must outlive it.
class MessageView {
 public:
  explicit MessageView(const google::protobuf::Message* message) : message_(message) {}

  /// Whether there is a message at all, and whether its type has a field of this name.
  bool isThere() const { return message_ != nullptr; }
  bool has(const char* name) const;
  /// A message within this one.
  MessageView in(const char* name) const;
  double number(const char* name) const;
  std::uint32_t natural(const char* name) const;
  const std::string& text(const char* name) const;

  /// The number of values of a list, and these.
  int count(const char* name) const;
  MessageView element(const char* name, int index) const;
  double numberAt(const char* name, int index) const;
  const std::string& textAt(const char* name, int index) const;
  /// All values of a list.
  std::vector<double> numbers(const char* name) const;

 private:
  const google::protobuf::FieldDescriptor* field(const char* name, bool isRepeated) const;
  double numberOf(const google::protobuf::FieldDescriptor* field, int element) const;
  const std::string& textOf(const google::protobuf::FieldDescriptor* field, int element) const;

  /// Null: it has nothing.
  const google::protobuf::Message* message_;
};

// Assign parts that many messages contain: `from` is the message with these fields.
void assign(google::protobuf::Timestamp& to, const MessageView& from);
void assign(foxglove::Vector3& to, const MessageView& from);
void assign(foxglove::Quaternion& to, const MessageView& from);

}  // namespace robotlink::ros
