// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "logplayer/mcap/Records.h"
#include "robotlink/process/Link.h"

namespace logplayer {

/// The type of a channel's messages, by its schema in the file. A type of this program is read into its class, any other
/// into a message that knows itself by the file's descriptors, which it keeps alive; what is no protobuf, or has a
/// schema that makes no sense, stays bytes (robotcontrol.PackageCopy). Immutable; any thread.
class MessageType {
 public:
  /// `schema`: null if the channel has none.
  MessageType(const mcap::Schema* schema, const std::string& messageEncoding);
  ~MessageType();
  MessageType(MessageType&&) noexcept;
  MessageType& operator=(MessageType&&) noexcept;

  /// As the schema says; "unknown" without one.
  const std::string& name() const { return name_; }
  /// Null if the bytes do not make such a message.
  robotlink::PackagePtr read(mcap::Bytes data) const;

 private:
  struct Dynamic;
  std::string name_;
  const google::protobuf::Message* prototype_ = nullptr;  // null: stays bytes
  std::shared_ptr<const Dynamic> dynamic_;                // what a prototype from the file belongs to
};

}  // namespace logplayer
