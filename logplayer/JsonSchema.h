// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.pb.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace logplayer {

/// Describes a Protobuf type as a JSON schema says; see JsonType. Used once.
class JsonSchema {
 public:
  /// What the values of a property become.
  struct Kind {
    google::protobuf::FieldDescriptorProto::Type type = google::protobuf::FieldDescriptorProto::TYPE_STRING;
    std::string typeName;  ///< of a message
    bool repeated = false;
  };
  static constexpr char kRowValues[] =
      "values";  ///< the field of a message that is a row of an array of arrays

  /// `root` must outlive it.
  explicit JsonSchema(const nlohmann::json& root) : root_(root) {}

  /// The file with the type, called as like `name` as may be, behind `package`. Without dependencies but time
  /// stamps and durations.
  google::protobuf::FileDescriptorProto describe(const std::string& name, const std::string& package);
  /// The full name of the type in it.
  const std::string& typeName() const { return typeName_; }
  /// The name of its field for what does not fit the schema.
  const std::string& otherFields() const { return otherFields_; }
  /// The names of fields, by the full names of their types and the properties that they are of.
  const std::map<std::pair<std::string, std::string>, std::string>& fields() const { return fields_; }
  /// A schema of an object like this one.
  static nlohmann::json ofValue(const nlohmann::json& value);

 private:
  const nlohmann::json& resolved(const nlohmann::json& schema) const;
  Kind kindOf(const nlohmann::json& schema, const std::string& hint);
  Kind kindOfObject(const nlohmann::json& schema, const std::string& hint);
  Kind kindOfArray(const nlohmann::json& schema, const std::string& hint);
  std::string messageFor(const nlohmann::json& properties, const std::string& hint);
  std::string rowFor(const Kind& value, const std::string& hint);
  google::protobuf::DescriptorProto& addMessage(const std::string& hint);
  static std::string addField(google::protobuf::DescriptorProto& to, const std::string& property,
                              const Kind& kind);
  std::string qualified(const std::string& message) const;

  const nlohmann::json& root_;
  google::protobuf::FileDescriptorProto file_;
  std::string typeName_, otherFields_;
  std::map<std::pair<std::string, std::string>, std::string> fields_;
  std::map<const nlohmann::json*, std::string> messages_;  // by the schemas that they are made of
  std::set<std::string> names_;                            // of messages
  int fieldCount_ = 0;
  int depth_ = 0;
};

}  // namespace logplayer
