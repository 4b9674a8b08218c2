// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "robotlink/process/Link.h"

namespace robotlink {

class JsonType;
namespace ros {
class RosType;
struct KnownType;
}  // namespace ros

/// How messages are described, in a log file or by a server.
struct MessageSchema {
  /// For protobuf the full name of the message type.
  std::string name;
  /// The encoding of `data`: "protobuf", "jsonschema", "ros1msg", "ros2msg", "ros2idl".
  std::string encoding;
  /// For protobuf a serialized FileDescriptorSet, otherwise text.
  std::string_view data;
};

/// The type of a channel's messages, determined by its schema. Protobuf messages of this
/// program's types are parsed into their classes, others into dynamic messages with the descriptors from the
/// schema, which they keep alive. JSON and the messages of ROS become dynamic messages, too, see JsonType and
/// ros::RosType; those that ros::knownType() lists are converted. Messages in other encodings (flatbuffer) or
/// with an invalid schema stay bytes (robotcontrol.PackageCopy). Immutable; any thread.
class MessageType {
 public:
  /// Returns a message of the channel, empty if there is none. Called only for JSON without a schema.
  using Sample = std::function<std::string()>;
  /// `schema` is null if the channel has none.
  MessageType(const MessageSchema* schema, const std::string& messageEncoding, const Sample& sample = {});
  /// The name() that the type of a channel has if its messages can be decoded, without its schema's text.
  static std::string expectedName(const std::string& schemaName, const std::string& messageEncoding);
  ~MessageType();
  MessageType(MessageType&&) noexcept;
  MessageType& operator=(MessageType&&) noexcept;

  /// The type name in the schema, or of the type that messages are converted to; "unknown" without a schema.
  const std::string& name() const { return name_; }
  /// The encoding of the messages: "protobuf", "json", "cdr", "ros1".
  const std::string& encoding() const { return encoding_; }
  /// Whether messages are decoded; otherwise they stay bytes.
  bool isDecoded() const { return prototype_ || json_ || ros_; }
  /// Decodes a message; null if the bytes are invalid.
  PackagePtr read(std::span<const std::uint8_t> data) const;

 private:
  /// Descriptor pool and message factory for the types of a schema.
  struct Dynamic;
  void readProtobufSchema(const MessageSchema& schema);
  void readJsonSchema(const MessageSchema* schema, const Sample& sample);
  void readRosDefinition(const MessageSchema& schema);

  std::string name_, encoding_;
  /// Null if the type is not Protobuf.
  const google::protobuf::Message* prototype_ = nullptr;
  /// Owns prototype_ if it was built from the schema; null for the program's own types.
  std::shared_ptr<const Dynamic> dynamic_;
  /// Null if the type is not JSON.
  std::shared_ptr<const JsonType> json_;
  /// Null if the type is not one of ROS.
  std::shared_ptr<const ros::RosType> ros_;
  /// The type to which its messages are converted; null: they are not.
  const ros::KnownType* knownRosType_ = nullptr;
};

}  // namespace robotlink
