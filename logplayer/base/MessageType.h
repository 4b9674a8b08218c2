// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "logplayer/mcap/Records.h"
#include "robotlink/process/Link.h"

namespace logplayer {

class JsonType;

/// The type of a channel's messages, determined by its schema in the file. Protobuf messages of this
/// program's types are parsed into their classes, others into dynamic messages with the descriptors from the
/// file, which they keep alive. JSON becomes dynamic messages, too, see JsonType. Messages in other encodings
/// (cdr, ros1) or with an invalid schema stay bytes (robotcontrol.PackageCopy). Immutable; any thread.
class MessageType {
 public:
  /// Returns a message of the channel, empty if there is none. Called only for JSON without a schema.
  using Sample = std::function<std::string()>;
  /// `schema` is null if the channel has none.
  MessageType(const mcap::Schema* schema, const std::string& messageEncoding, const Sample& sample = {});
  ~MessageType();
  MessageType(MessageType&&) noexcept;
  MessageType& operator=(MessageType&&) noexcept;

  /// The type name in the schema; "unknown" without one.
  const std::string& name() const { return name_; }
  /// The encoding as in the file: "protobuf", "json", "cdr", "ros1".
  const std::string& encoding() const { return encoding_; }
  /// Whether messages are decoded; otherwise they stay bytes.
  bool isDecoded() const { return prototype_ != nullptr || json_ != nullptr; }
  /// Decodes a message; null if the bytes are invalid.
  robotlink::PackagePtr read(mcap::Bytes data) const;

 private:
  /// Descriptor pool and message factory for the types of a file.
  struct Dynamic;
  void readProtobufSchema(const mcap::Schema& schema);
  void readJsonSchema(const mcap::Schema* schema, const Sample& sample);

  std::string name_, encoding_;
  /// Null if the type is not Protobuf.
  const google::protobuf::Message* prototype_ = nullptr;
  /// Owns prototype_ if it was built from the file; null for the program's own types.
  std::shared_ptr<const Dynamic> dynamic_;
  /// Null if the type is not JSON.
  std::shared_ptr<const JsonType> json_;
};

}  // namespace logplayer
