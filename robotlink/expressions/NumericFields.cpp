// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/NumericFields.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <set>

#include "robotlink/packages/FieldValues.h"

namespace robotlink {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr int kMaxDepth = 5;
constexpr int kMaxElements = 32;
constexpr std::size_t kMaxFields = 1000;

bool isListed(const FieldDescriptor& field, FieldChoice choice) {
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) return isTime(*field.message_type());
  if (field.type() == FieldDescriptor::TYPE_STRING) return choice == FieldChoice::kNumbersAndTexts;
  return field.cpp_type() != FieldDescriptor::CPPTYPE_STRING;
}

bool isPart(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && !field.is_map() &&
         !isTime(*field.message_type());
}

const FieldDescriptor* nameField(const Descriptor& type) {
  const FieldDescriptor* field = type.FindFieldByName("name");
  const bool isText = field && !field->is_repeated() && field->type() == FieldDescriptor::TYPE_STRING;
  return isText ? field : nullptr;
}

void listType(const Descriptor& type, FieldChoice choice, const std::string& prefix, int depth,
              std::vector<std::string>& paths) {
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    const int elements = field.is_repeated() ? kMaxElements : 1;
    for (int e = 0; e < elements && paths.size() < kMaxFields; ++e) {
      const std::string path =
          prefix + field.name() + (field.is_repeated() ? "[" + std::to_string(e) + "]" : "");
      if (isListed(field, choice)) paths.push_back(path);
      if (isPart(field) && depth < kMaxDepth)
        listType(*field.message_type(), choice, path + ".", depth + 1, paths);
    }
  }
}

void listMessage(const Message& message, FieldChoice choice, const std::string& prefix, int depth,
                 std::vector<std::string>& paths) {
  const Reflection& reflection = *message.GetReflection();
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    const bool absent = !field.is_repeated() && field.has_presence() && !reflection.HasField(message, &field);
    const int elements = field.is_repeated() ? reflection.FieldSize(message, &field) : absent ? 0 : 1;
    // A name leads to the first element that has it.
    std::set<std::string> known;
    for (int e = 0; e < elements && paths.size() < kMaxFields; ++e) {
      const Message* part = !isPart(field)        ? nullptr
                            : field.is_repeated() ? &reflection.GetRepeatedMessage(message, &field, e)
                                                  : &reflection.GetMessage(message, &field);
      std::string key = part ? elementKey(*part, e) : std::to_string(e);
      if (!known.insert(key).second) key = std::to_string(e);
      const std::string path = prefix + field.name() + (field.is_repeated() ? "[" + key + "]" : "");
      if (isListed(field, choice)) paths.push_back(path);
      if (part && depth < kMaxDepth) listMessage(*part, choice, path + ".", depth + 1, paths);
    }
  }
}

}  // namespace

std::vector<std::string> numericFields(const Descriptor& type, FieldChoice choice) {
  std::vector<std::string> paths;
  listType(type, choice, "", 1, paths);
  return paths;
}

std::vector<std::string> numericFields(const Message& message, FieldChoice choice) {
  std::vector<std::string> paths;
  listMessage(message, choice, "", 1, paths);
  return paths;
}

std::string elementKey(const Message& element, int index) {
  const FieldDescriptor* field = nameField(*element.GetDescriptor());
  const std::string name = field ? element.GetReflection()->GetString(element, field) : std::string();
  const bool fits = !name.empty() && name.find_first_of("[]") == std::string::npos &&
                    name.find_first_not_of("0123456789") != std::string::npos;
  return fits ? name : std::to_string(index);
}

}  // namespace robotlink
