// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "robotlink/process/Link.h"

namespace robotlink {

/// The type of messages that are JSON objects: a Protobuf type derived from their JSON schema, so that
/// everything that shows, plots or exports Protobuf messages supports them, too. A schema with the name of
/// one of this program's own types (foxglove.Log) yields that type, if it has all properties of the schema.
/// Objects {sec, nsec} become timestamps; strings with contentEncoding base64 become bytes; values without a
/// fixed type (oneOf, objects without properties) become text with their JSON. Values that are not in the
/// schema, or contradict it, are stored as JSON in the field `other_fields`, so that nothing is lost.
///
/// Input is untrusted: depth and size are limited. Immutable; any thread.
class JsonType {
 public:
  /// Null if the schema is not that of an object with properties.
  static std::shared_ptr<const JsonType> ofSchema(const std::string& name, const std::string& schema);
  /// Returns the type of messages without a schema, by what the first of them holds. Null if that is no JSON
  /// object.
  static std::shared_ptr<const JsonType> ofMessage(const std::string& name,
                                                   std::span<const std::uint8_t> message);
  ~JsonType();

  /// The full name of the Protobuf type.
  const std::string& name() const;
  /// Parses a message; null if the bytes are not a JSON object. The message keeps `type` alive.
  static PackagePtr read(const std::shared_ptr<const JsonType>& type, std::span<const std::uint8_t> data);

 private:
  struct Implementation;
  explicit JsonType(std::unique_ptr<Implementation> implementation);
  /// Builds the type from a schema; `mayBeEmpty`: whether an object without properties is accepted.
  static std::shared_ptr<const JsonType> make(const std::string& name, const nlohmann::json& root,
                                              bool mayBeEmpty);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink
