// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/decoding/JsonSchema.h"

#include <algorithm>
#include <cctype>

#include "robotlink/decoding/JsonText.h"

namespace robotlink {

using google::protobuf::DescriptorProto;
using google::protobuf::FieldDescriptorProto;
using google::protobuf::FileDescriptorProto;
using nlohmann::json;

namespace {

constexpr int kMaxFields = 4000;    // of all messages; further properties go to the other fields
constexpr int kMaxReferences = 16;  // maximum length of a chain of $ref
constexpr char kTimestamp[] = ".google.protobuf.Timestamp";
constexpr char kDuration[] = ".google.protobuf.Duration";

/// Converts a text to an identifier: letters, digits and "_", not beginning with a digit.
std::string identifier(const std::string& text) {
  std::string name;
  for (const char c : text) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0) name.insert(0, "_");
  return name;
}

/// A text member of an object; "" if it is missing.
std::string textAt(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

const json* memberAt(const json& object, const char* key, json::value_t type) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found != object.end() && found->type() == type ? &*found : nullptr;
}

/// The name of a value's type in the keyword "type".
std::string typeOfValue(const json& value) {
  if (value.is_string()) return "string";
  if (value.is_boolean()) return "boolean";
  return value.is_number_integer() ? "integer" : value.is_number() ? "number" : "";
}

/// The common type of the values of "enum" or "const"; "" if there is none.
std::string typeOfConstants(const json& schema) {
  if (const auto constant = schema.find("const"); constant != schema.end()) return typeOfValue(*constant);
  const json* values = memberAt(schema, "enum", json::value_t::array);
  if (values == nullptr || values->empty()) return {};
  const std::string type = typeOfValue(values->front());
  const bool same = std::all_of(values->begin(), values->end(),
                                [&](const json& value) { return typeOfValue(value) == type; });
  return same ? type : std::string();
}

/// The schema's type; of several the one besides "null"; "" if there is no single one.
std::string typeOf(const json& schema) {
  if (!schema.is_object()) return {};
  if (const std::string type = textAt(schema, "type"); !type.empty()) return type;
  const json* types = memberAt(schema, "type", json::value_t::array);
  if (types == nullptr) {
    if (memberAt(schema, "properties", json::value_t::object) != nullptr) return "object";
    return schema.contains("items") ? "array" : typeOfConstants(schema);
  }
  std::set<std::string> names;
  for (const json& type : *types) {
    if (type.is_string() && type != "null") names.insert(type.get<std::string>());
  }
  if (names == std::set<std::string>{"integer", "number"}) return "number";
  return names.size() == 1 ? *names.begin() : std::string();
}

/// Returns the only one of a schema's alternatives that is not "null", or any if all are of one plain type;
/// else null.
const json* onlyAlternative(const json& schema) {
  for (const char* key : {"oneOf", "anyOf", "allOf"}) {
    const json* all = memberAt(schema, key, json::value_t::array);
    if (all == nullptr) continue;
    const json* only = nullptr;
    for (const json& alternative : *all) {
      if (typeOf(alternative) == "null") continue;
      const std::string type = typeOf(alternative);
      const bool plain = !type.empty() && type != "object" && type != "array";
      if (only != nullptr && (!plain || typeOf(*only) != type)) return nullptr;
      only = &alternative;
    }
    return only;
  }
  return nullptr;
}

/// Whether an object is a time, as ROS and Foxglove have them.
bool isTimeSchema(const json& properties) {
  if (properties.size() != 2 || !properties.contains("sec")) return false;
  if (!properties.contains("nsec") && !properties.contains("nanosec")) return false;
  return std::all_of(properties.begin(), properties.end(),
                     [](const json& property) { return typeOf(property) == "integer"; });
}

}  // namespace

FileDescriptorProto JsonSchema::describe(const std::string& name, const std::string& package) {
  std::string path = package;
  std::string last;
  for (std::size_t from = 0; from <= name.size();) {
    const std::size_t end = std::min(name.find_first_of("./", from), name.size());
    if (!last.empty()) path += (path.empty() ? "" : ".") + last;
    if (end > from) last = identifier(name.substr(from, end - from));
    if (end == from && !last.empty()) last.clear();
    from = end + 1;
  }
  if (last.empty()) last = "Message";
  file_.set_name("message.json.proto");
  file_.set_syntax("proto2");
  file_.set_package(path);
  file_.add_dependency("google/protobuf/timestamp.proto");
  file_.add_dependency("google/protobuf/duration.proto");
  const json* properties = memberAt(resolved(root_), "properties", json::value_t::object);
  static const json kNone = json::object();
  const std::string root = messageFor(properties != nullptr ? *properties : kNone, last);
  typeName_ = root.substr(1);
  for (DescriptorProto& message : *file_.mutable_message_type()) {
    if (qualified(message.name()) == root) otherFields_ = addField(message, "other_fields", {});
  }
  return std::move(file_);
}

std::string JsonSchema::qualified(const std::string& message) const {
  return "." + (file_.package().empty() ? "" : file_.package() + ".") + message;
}

/// Follows references within the schema; returns the schema itself if they lead nowhere.
const json& JsonSchema::resolved(const json& schema) const {
  const json* at = &schema;
  for (int i = 0; i < kMaxReferences && at->is_object(); ++i) {
    if (const json* only = onlyAlternative(*at); only != nullptr && typeOf(*at).empty()) at = only;
    if (!at->is_object()) break;
    const std::string reference = textAt(*at, "$ref");
    if (!reference.starts_with('#')) break;
    try {
      at = &root_.at(json::json_pointer(reference.substr(1)));
    } catch (const json::exception&) {
      break;
    }
  }
  return *at;
}

JsonSchema::Kind JsonSchema::kindOf(const json& given, const std::string& hint) {
  const json& schema = resolved(given);
  const std::string type = typeOf(schema);
  if (type == "object" || type == "array") {
    if (depth_ >= kMaxJsonDepth) return {};
    ++depth_;
    Kind kind = type == "object" ? kindOfObject(schema, hint) : kindOfArray(schema, hint);
    --depth_;
    return kind;
  }
  if (type == "number") return {FieldDescriptorProto::TYPE_DOUBLE, {}, false};
  if (type == "integer") return {FieldDescriptorProto::TYPE_INT64, {}, false};
  if (type == "boolean") return {FieldDescriptorProto::TYPE_BOOL, {}, false};
  const bool bytes = type == "string" && textAt(schema, "contentEncoding") == "base64";
  return {bytes ? FieldDescriptorProto::TYPE_BYTES : FieldDescriptorProto::TYPE_STRING, {}, false};
}

JsonSchema::Kind JsonSchema::kindOfObject(const json& schema, const std::string& hint) {
  const json* properties = memberAt(schema, "properties", json::value_t::object);
  if (properties == nullptr || properties->empty()) return {};
  if (isTimeSchema(*properties)) {
    const bool duration = textAt(schema, "title") == "duration";
    return {FieldDescriptorProto::TYPE_MESSAGE, duration ? kDuration : kTimestamp, false};
  }
  return {FieldDescriptorProto::TYPE_MESSAGE, messageFor(*properties, hint), false};
}

/// Arrays of arrays become repeated rows.
JsonSchema::Kind JsonSchema::kindOfArray(const json& schema, const std::string& hint) {
  const json* items = memberAt(schema, "items", json::value_t::object);
  if (items == nullptr) return {FieldDescriptorProto::TYPE_STRING, {}, true};
  Kind kind = kindOf(*items, hint);
  if (kind.repeated) kind = {FieldDescriptorProto::TYPE_MESSAGE, rowFor(kind, hint), true};
  kind.repeated = true;
  return kind;
}

DescriptorProto& JsonSchema::addMessage(const std::string& hint) {
  std::string name = hint;
  for (int number = 2; !names_.insert(name).second; ++number) name = hint + "_" + std::to_string(number);
  DescriptorProto& message = *file_.add_message_type();
  message.set_name(name);
  return message;
}

/// Adds one type per schema, so that recursive schemas terminate.
std::string JsonSchema::messageFor(const json& properties, const std::string& hint) {
  if (const auto known = messages_.find(&properties); known != messages_.end()) return known->second;
  const std::string name = addMessage(hint).name();
  const int index = file_.message_type_size() - 1;
  const std::string fullName = qualified(name);
  messages_[&properties] = fullName;
  DescriptorProto message;  // built here, since messages in the file move when another one is added
  message.set_name(name);
  for (const auto& [property, schema] : properties.items()) {
    if (++fieldCount_ > kMaxFields) break;
    const Kind kind = kindOf(schema, name + "_" + identifier(property));
    fields_[{fullName.substr(1), property}] = addField(message, property, kind);
  }
  *file_.mutable_message_type(index) = std::move(message);
  return fullName;
}

std::string JsonSchema::rowFor(const Kind& value, const std::string& hint) {
  DescriptorProto& row = addMessage(hint + "_row");
  addField(row, kRowValues, value);
  return qualified(row.name());
}

std::string JsonSchema::addField(DescriptorProto& to, const std::string& property, const Kind& kind) {
  const std::string wanted = identifier(property);
  int& number = lastNumbers_[{to.name(), wanted}];
  std::string name = wanted;
  if (number > 0) name += "_" + std::to_string(++number);
  while (!fieldNames_.insert({to.name(), name}).second) {
    number = std::max(number + 1, 2);
    name = wanted + "_" + std::to_string(number);
  }
  number = std::max(number, 1);
  FieldDescriptorProto& field = *to.add_field();
  field.set_name(name);
  field.set_number(to.field_size() < 19'000 ? to.field_size()
                                            // Skips the numbers reserved by Protobuf.
                                            : to.field_size() + 1000);
  field.set_type(kind.type);
  field.set_label(kind.repeated ? FieldDescriptorProto::LABEL_REPEATED
                                : FieldDescriptorProto::LABEL_OPTIONAL);
  if (kind.type == FieldDescriptorProto::TYPE_MESSAGE) field.set_type_name(kind.typeName);
  return name;
}

// ---- Without a schema

json JsonSchema::ofValue(const json& value) {
  switch (value.type()) {
    case json::value_t::object: {
      json properties = json::object();
      for (const auto& [key, member] : value.items()) properties[key] = ofValue(member);
      return {{"type", "object"}, {"properties", std::move(properties)}};
    }
    case json::value_t::array:
      if (value.empty()) return {{"type", "array"}};
      return {{"type", "array"}, {"items", ofValue(value.front())}};
    case json::value_t::boolean:
      return {{"type", "boolean"}};
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
    case json::value_t::number_float:
      return {{"type", "number"}};  // later values may have a fraction
    default:
      return {{"type", "string"}};
  }
}

}  // namespace robotlink
