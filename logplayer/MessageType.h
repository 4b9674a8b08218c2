// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "logplayer/mcap/Records.h"
#include "robotlink/process/Link.h"

namespace logplayer {

class JsonType;

/// The type of a channel's messages, by its schema in the file. Protobuf of a type of this program is read
/// into its class, any other into a message that knows itself by the file's descriptors, which it keeps
/// alive; JSON becomes such messages, too, see JsonType. What is otherwise encoded (cdr, ros1), or has a
/// schema that makes no sense, stays bytes (robotcontrol.PackageCopy). Immutable; any thread.
class MessageType {
 public:
  /// A message of the channel, which may be asked for where JSON has no schema; empty if there is none.
  using Sample = std::function<std::string()>;
  /// `schema`: null if the channel has none.
  MessageType(const mcap::Schema* schema, const std::string& messageEncoding, const Sample& sample = {});
  ~MessageType();
  MessageType(MessageType&&) noexcept;
  MessageType& operator=(MessageType&&) noexcept;

  /// As the schema says; "unknown" without one.
  const std::string& name() const { return name_; }
  /// As the file says: "protobuf", "json", "cdr", "ros1".
  const std::string& encoding() const { return encoding_; }
  /// Whether messages are read as values; else they stay bytes.
  bool isDecoded() const { return prototype_ != nullptr || json_ != nullptr; }
  /// Null if the bytes do not make such a message.
  robotlink::PackagePtr read(mcap::Bytes data) const;

 private:
  struct Dynamic;
  void readProtobufSchema(const mcap::Schema& schema);
  void readJsonSchema(const mcap::Schema* schema, const Sample& sample);

  std::string name_, encoding_;
  const google::protobuf::Message* prototype_ = nullptr;  // null: no Protobuf
  std::shared_ptr<const Dynamic> dynamic_;                // what a prototype from the file belongs to
  std::shared_ptr<const JsonType> json_;
};

}  // namespace logplayer
