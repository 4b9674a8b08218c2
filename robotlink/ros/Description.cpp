// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/Description.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace robotlink::ros {

using google::protobuf::DescriptorProto;
using google::protobuf::EnumDescriptorProto;
using google::protobuf::FieldDescriptorProto;
using google::protobuf::FileDescriptorProto;

namespace {

constexpr char kTimestamp[] = ".google.protobuf.Timestamp";
constexpr char kDuration[] = ".google.protobuf.Duration";

FieldDescriptorProto::Type scalarType(const Field& field) {
  switch (field.kind) {
    case Kind::kBool:
      return FieldDescriptorProto::TYPE_BOOL;
    case Kind::kUint8:
      return field.shape == Shape::kSingle ? FieldDescriptorProto::TYPE_UINT32
                                           : FieldDescriptorProto::TYPE_BYTES;
    case Kind::kInt8:
    case Kind::kInt16:
    case Kind::kInt32:
      return FieldDescriptorProto::TYPE_INT32;
    case Kind::kUint16:
    case Kind::kUint32:
      return FieldDescriptorProto::TYPE_UINT32;
    case Kind::kInt64:
      return FieldDescriptorProto::TYPE_INT64;
    case Kind::kUint64:
      return FieldDescriptorProto::TYPE_UINT64;
    case Kind::kFloat32:
      return FieldDescriptorProto::TYPE_FLOAT;
    case Kind::kFloat64:
      return FieldDescriptorProto::TYPE_DOUBLE;
    case Kind::kString:
    case Kind::kWstring:
      return FieldDescriptorProto::TYPE_STRING;
    case Kind::kTime:
    case Kind::kDuration:
    case Kind::kStruct:
      break;
  }
  return FieldDescriptorProto::TYPE_MESSAGE;
}

/// The names of a message's fields. Protobuf refuses those that differ in capitals and underscores only.
class FieldNames {
 public:
  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; !names_.insert(folded(name)).second; ++number)
      name = wanted + "_" + std::to_string(number);
    return name;
  }

 private:
  static std::string folded(const std::string& name) {
    std::string text;
    for (const char c : name)
      if (c != '_') text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  }
  std::set<std::string> names_;
};

bool hasZero(const Field& field) {
  return std::ranges::any_of(field.enumerators, [](const auto& one) { return one.second == 0; });
}

/// Adds the enumeration of a field's values, of which Protobuf wants the one that is 0 first.
void addEnumeration(DescriptorProto& to, const Field& field, FieldDescriptorProto& described) {
  EnumDescriptorProto& enumeration = *to.add_enum_type();
  enumeration.set_name(described.name() + "_values");
  enumeration.mutable_options()->set_allow_alias(true);
  auto values = field.enumerators;
  std::stable_partition(values.begin(), values.end(), [](const auto& one) { return one.second == 0; });
  for (const auto& [name, number] : values) {
    auto& value = *enumeration.add_value();
    value.set_name(name);
    value.set_number(number);
  }
  described.set_type(FieldDescriptorProto::TYPE_ENUM);
  described.set_type_name(enumeration.name());
}

/// A part of a name with only the characters that Protobuf allows.
std::string identifier(std::string part) {
  for (char& c : part)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  if (part.empty() || std::isdigit(static_cast<unsigned char>(part[0])) != 0) part.insert(0, "_");
  return part;
}

}  // namespace

int fieldNumber(std::size_t index) {
  const int number = static_cast<int>(index) + 1;
  return number < 19'000 ? number : number + 1000;  // Protobuf has reserved those between
}

std::string typeName(const std::string& structName, const std::string& package) {
  std::string name = package;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = structName.find('/', begin);
    name += (name.empty() ? "" : ".") + identifier(structName.substr(begin, end - begin));
  }
  return name;
}

FileDescriptorProto describe(const std::string& structName, const Struct& definition,
                             const std::string& package, Enumerations enumerations) {
  const std::string fullName = typeName(structName, package);
  const auto dot = fullName.rfind('.');
  FileDescriptorProto file;
  file.set_name(structName);
  file.set_syntax("proto3");
  if (dot != std::string::npos) file.set_package(fullName.substr(0, dot));
  file.add_dependency("google/protobuf/timestamp.proto");
  file.add_dependency("google/protobuf/duration.proto");
  DescriptorProto& message = *file.add_message_type();
  message.set_name(fullName.substr(dot + 1));
  std::set<std::string> imports;
  FieldNames names;
  for (const Field& field : definition.fields) {
    FieldDescriptorProto& described = *message.add_field();
    described.set_name(names.unique(identifier(field.name)));
    described.set_number(fieldNumber(static_cast<std::size_t>(message.field_size() - 1)));
    described.set_type(scalarType(field));
    const bool isBytes = described.type() == FieldDescriptorProto::TYPE_BYTES;
    described.set_label(field.shape == Shape::kSingle || isBytes ? FieldDescriptorProto::LABEL_OPTIONAL
                                                                 : FieldDescriptorProto::LABEL_REPEATED);
    if (field.kind == Kind::kTime) described.set_type_name(kTimestamp);
    if (field.kind == Kind::kDuration) described.set_type_name(kDuration);
    if (field.kind == Kind::kStruct) {
      described.set_type_name("." + typeName(field.structName, package));
      if (imports.insert(field.structName).second) file.add_dependency(field.structName);
    }
    if (enumerations == Enumerations::kNamed && hasZero(field)) addEnumeration(message, field, described);
  }
  return file;
}

}  // namespace robotlink::ros
