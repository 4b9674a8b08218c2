// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.pb.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace robotlink {

/// Translates a JSON schema into the description of a Protobuf type; see JsonType for the rules. An object
/// translates one schema; describe() may be called once.
class JsonSchema {
 public:
  /// The Protobuf field type for the values of a property.
  struct Kind {
    google::protobuf::FieldDescriptorProto::Type type = google::protobuf::FieldDescriptorProto::TYPE_STRING;
    /// The full name of a message type; empty otherwise.
    std::string typeName;
    bool repeated = false;
  };
  /// The field of a message that represents a row of an array of arrays.
  static constexpr char kRowValues[] = "values";

  /// `root` must outlive this object.
  explicit JsonSchema(const nlohmann::json& root) : root_(root) {}

  /// Returns a file with the type, in `package` and named as similarly to `name` as Protobuf allows. Its only
  /// dependencies are the types for timestamps and durations.
  google::protobuf::FileDescriptorProto describe(const std::string& name, const std::string& package);
  /// The full name of the type. Valid after describe(), like all that follows.
  const std::string& typeName() const { return typeName_; }
  /// The name of its field for everything that does not fit the schema.
  const std::string& otherFields() const { return otherFields_; }
  /// The names of fields by (full name of the message type, name of the JSON property).
  const std::map<std::pair<std::string, std::string>, std::string>& fields() const { return fields_; }
  /// Derives a schema from a value, for objects like this one.
  static nlohmann::json ofValue(const nlohmann::json& value);

 private:
  /// Follows references ($ref) within the schema.
  const nlohmann::json& resolved(const nlohmann::json& schema) const;
  /// The field type for a schema; `hint` suggests a name for a new message type.
  Kind kindOf(const nlohmann::json& schema, const std::string& hint);
  Kind kindOfObject(const nlohmann::json& schema, const std::string& hint);
  Kind kindOfArray(const nlohmann::json& schema, const std::string& hint);
  /// Adds a message type for an object, or returns the one made before from the same schema.
  std::string messageFor(const nlohmann::json& properties, const std::string& hint);
  /// Adds a message type that holds one row of an array of arrays.
  std::string rowFor(const Kind& value, const std::string& hint);
  /// Adds an empty message type with a unique name.
  google::protobuf::DescriptorProto& addMessage(const std::string& hint);
  /// Adds a field for a property and returns its name.
  std::string addField(google::protobuf::DescriptorProto& to, const std::string& property, const Kind& kind);
  /// The full name of a message type of the file.
  std::string qualified(const std::string& message) const;

  const nlohmann::json& root_;
  google::protobuf::FileDescriptorProto file_;
  std::string typeName_, otherFields_;
  std::map<std::pair<std::string, std::string>, std::string> fields_;
  /// Full names by the schemas that they were made from; ends recursion.
  std::map<const nlohmann::json*, std::string> messages_;
  /// The names of all message types.
  std::set<std::string> names_;
  /// The names of all fields, by (name of the message type, name).
  std::set<std::pair<std::string, std::string>> fieldNames_;
  /// The last number that was appended to a field's name so that it is unique, by the same; 1: none yet.
  std::map<std::pair<std::string, std::string>, int> lastNumbers_;
  /// Limits against schemas that are huge or deeply nested.
  int fieldCount_ = 0;
  int depth_ = 0;
};

}  // namespace robotlink
