// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/Numbers.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <string_view>
#include <type_traits>

#include "robotlink/base/ParsedNumber.h"
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

bool isNumber(const FieldDescriptor& field) {
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) return isTime(*field.message_type());
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

// The name of an element if it has one that a path can contain, otherwise its index.
std::string elementKey(const Message& element, int index) {
  const FieldDescriptor* field = nameField(*element.GetDescriptor());
  const std::string name = field ? element.GetReflection()->GetString(element, field) : std::string();
  const bool fits = !name.empty() && name.find_first_of("[]") == std::string::npos &&
                    name.find_first_not_of("0123456789") != std::string::npos;
  return fits ? name : std::to_string(index);
}

void listType(const Descriptor& type, const std::string& prefix, int depth, std::vector<std::string>& paths) {
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    const int elements = field.is_repeated() ? kMaxElements : 1;
    for (int e = 0; e < elements && paths.size() < kMaxFields; ++e) {
      const std::string path =
          prefix + field.name() + (field.is_repeated() ? "[" + std::to_string(e) + "]" : "");
      if (isNumber(field)) paths.push_back(path);
      if (isPart(field) && depth < kMaxDepth) listType(*field.message_type(), path + ".", depth + 1, paths);
    }
  }
}

void listMessage(const Message& message, const std::string& prefix, int depth,
                 std::vector<std::string>& paths) {
  const Reflection& reflection = *message.GetReflection();
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    const bool absent = !field.is_repeated() && field.has_presence() && !reflection.HasField(message, &field);
    const int elements = field.is_repeated() ? reflection.FieldSize(message, &field) : absent ? 0 : 1;
    for (int e = 0; e < elements && paths.size() < kMaxFields; ++e) {
      const Message* part = !isPart(field)        ? nullptr
                            : field.is_repeated() ? &reflection.GetRepeatedMessage(message, &field, e)
                                                  : &reflection.GetMessage(message, &field);
      const std::string key = part ? elementKey(*part, e) : std::to_string(e);
      const std::string path = prefix + field.name() + (field.is_repeated() ? "[" + key + "]" : "");
      if (isNumber(field)) paths.push_back(path);
      if (part && depth < kMaxDepth) listMessage(*part, path + ".", depth + 1, paths);
    }
  }
}

/// `element` is -1 for a field that is not repeated. Empty if the value is no number.
std::optional<double> numberOf(const Message& message, const FieldDescriptor& field, int element) {
  return visitValue(message, field, element, [](const auto& value) -> std::optional<double> {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<Value>) {
      return static_cast<double>(value);
    } else if constexpr (std::is_same_v<Value, EnumNumber>) {
      return value.number;
    } else if constexpr (std::is_same_v<Value, Message>) {
      if (!isTime(*value.GetDescriptor())) return std::nullopt;
      return static_cast<double>(wholeSeconds(value)) + nanoseconds(value) * 1e-9;
    } else {
      return std::nullopt;
    }
  });
}

// A step of a path: "joints[3]", "joints[head/pan]" or "position".
struct Step {
  std::string name;
  std::optional<std::string_view> element;
};

// Removes the first step from the path and returns it; empty if the path is malformed. A name in brackets may
// contain dots.
std::optional<Step> takeStep(std::string_view& path) {
  const std::size_t end = std::min(path.find_first_of(".["), path.size());
  Step step{std::string(path.substr(0, end)), std::nullopt};
  path.remove_prefix(end);
  if (path.starts_with('[')) {
    const std::size_t close = path.find(']');
    if (close == std::string_view::npos) return std::nullopt;
    step.element = path.substr(1, close - 1);
    path.remove_prefix(close + 1);
  }
  if (path.empty()) return step;
  if (!path.starts_with('.') || path.size() == 1) return std::nullopt;
  path.remove_prefix(1);
  return step;
}

// The index of an element with this number or name; -1 if there is none.
int elementIndex(const Message& message, const FieldDescriptor& field, std::string_view key) {
  const Reflection& reflection = *message.GetReflection();
  const int size = reflection.FieldSize(message, &field);
  if (const auto index = parsedNumber<int>(key)) return *index >= 0 && *index < size ? *index : -1;
  const FieldDescriptor* name = isPart(field) ? nameField(*field.message_type()) : nullptr;
  for (int i = 0; name && i < size; ++i) {
    const Message& element = reflection.GetRepeatedMessage(message, &field, i);
    if (element.GetReflection()->GetString(element, name) == key) return i;
  }
  return -1;
}

}  // namespace

std::vector<std::string> numericFields(const Descriptor& type) {
  std::vector<std::string> paths;
  listType(type, "", 1, paths);
  return paths;
}

std::vector<std::string> numericFields(const Message& message) {
  std::vector<std::string> paths;
  listMessage(message, "", 1, paths);
  return paths;
}

std::optional<double> numberAt(const Message& message, const std::string& path) {
  std::string_view rest = path;
  for (const Message* at = &message;;) {
    const auto step = takeStep(rest);
    const FieldDescriptor* field = step ? at->GetDescriptor()->FindFieldByName(step->name) : nullptr;
    if (!field || field->is_repeated() != step->element.has_value()) return std::nullopt;
    const Reflection& reflection = *at->GetReflection();
    const int index = field->is_repeated() ? elementIndex(*at, *field, *step->element) : -1;
    if (field->is_repeated() && index < 0) return std::nullopt;
    if (!field->is_repeated() && field->has_presence() && !reflection.HasField(*at, field))
      return std::nullopt;
    if (rest.empty()) return numberOf(*at, *field, index);
    if (!isPart(*field)) return std::nullopt;
    at = field->is_repeated() ? &reflection.GetRepeatedMessage(*at, field, index)
                              : &reflection.GetMessage(*at, field);
  }
}

}  // namespace robotlink
