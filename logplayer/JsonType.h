// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "logplayer/mcap/Records.h"
#include "robotlink/process/Link.h"

namespace logplayer {

/// The type of messages that are JSON objects: a Protobuf type made of their JSON schema, so that everything
/// that shows, plots or exports messages takes them, too. A schema of one of this program's own types
/// (foxglove.Log) gives that type, if all that it names is there. Objects {sec, nsec} are time stamps;
/// strings with contentEncoding base64 are bytes; what has no fixed type (oneOf, objects without properties)
/// is the text of its JSON. What a message holds beside its schema, or otherwise than it says, stands as JSON
/// in the field `other_fields`, so that nothing is lost.
///
/// Files of others are read: nothing here believes them, or needs more than a fixed depth. Immutable; any
/// thread.
class JsonType {
 public:
  /// Null if the schema names no properties of an object.
  static std::shared_ptr<const JsonType> ofSchema(const std::string& name, const std::string& schema);
  /// Returns the type of messages without a schema, by what the first of them holds. Null if that is no JSON
  /// object.
  static std::shared_ptr<const JsonType> ofMessage(const std::string& name, mcap::Bytes message);
  ~JsonType();

  /// The Protobuf type's full name.
  const std::string& name() const;
  /// Null if the bytes are no JSON object. The message keeps `type` alive.
  static robotlink::PackagePtr read(const std::shared_ptr<const JsonType>& type, mcap::Bytes data);

 private:
  struct Implementation;
  explicit JsonType(std::unique_ptr<Implementation> implementation);
  static std::shared_ptr<const JsonType> make(const std::string& name, const nlohmann::json& root,
                                              bool mayBeEmpty);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer
