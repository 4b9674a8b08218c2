// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/MsgReader.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/TextParts.h"
#include "robotlink/ros/Resolution.h"

namespace robotlink::ros {
namespace {

/// Takes the characters up to one of `ends` off the text.
std::string_view takeUntil(std::string_view& text, std::string_view ends) {
  const std::string_view taken = text.substr(0, text.find_first_of(ends));
  text.remove_prefix(taken.size());
  return taken;
}

bool isName(std::string_view text) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         std::ranges::all_of(text, fits);
}

/// "string", "sensor_msgs/Image", "sensor_msgs/msg/Image".
bool isTypeName(std::string_view text) {
  while (true) {
    if (!isName(takeUntil(text, "/"))) return false;
    if (text.empty()) return true;
    text.remove_prefix(1);
  }
}

std::optional<Kind> builtin(std::string_view name, Version version) {
  static const std::map<std::string_view, Kind> kKinds{
      {"bool", Kind::kBool},       {"int8", Kind::kInt8},       {"uint8", Kind::kUint8},
      {"int16", Kind::kInt16},     {"uint16", Kind::kUint16},   {"int32", Kind::kInt32},
      {"uint32", Kind::kUint32},   {"int64", Kind::kInt64},     {"uint64", Kind::kUint64},
      {"float32", Kind::kFloat32}, {"float64", Kind::kFloat64}, {"string", Kind::kString},
      {"wstring", Kind::kWstring}, {"time", Kind::kTime},       {"duration", Kind::kDuration},
      {"char", Kind::kUint8},      {"byte", Kind::kUint8}};
  if (name == "byte" && version == Version::kRos1) return Kind::kInt8;
  const auto found = kKinds.find(name);
  return found == kKinds.end() ? std::nullopt : std::optional(found->second);
}

/// Whether it may number the values of an enumeration, which has 32 bits.
bool isEnumerable(Kind kind) {
  return kind >= Kind::kInt8 && kind <= Kind::kUint32;
}

/// Constants in a row whose type is that of the next field, perhaps.
struct Constants {
  Kind kind = Kind::kStruct;
  std::vector<std::pair<std::string, std::int32_t>> values;
};

/// Reads the definitions line by line.
class MsgReader {
 public:
  MsgReader(const std::string& name, Version version) : name_(name), version_(version) { begin(name); }

  Result<void> read(std::string_view text);
  const std::map<std::string, Struct>& structs() const { return structs_; }

 private:
  Result<void> readLine(std::string_view line);
  Result<void> readField(std::string_view line);
  Result<void> readType(std::string_view type, Field& field) const;
  Result<void> readShape(std::string_view brackets, Field& field) const;
  void addConstant(const Field& type, std::string_view name, std::string_view value);
  void begin(const std::string& structName) {
    current_ = &structs_[structKey(structName)];
    *current_ = {};
    constants_ = {};
  }
  tl::unexpected<Error> error(std::string text) const {
    return failure("ros.definition", std::move(text), {name_, line_, 0});
  }

  const std::string& name_;
  const Version version_;
  std::map<std::string, Struct> structs_;
  Struct* current_ = nullptr;
  Constants constants_;
  bool isAfterSeparator_ = false;
  int line_ = 0;
};

Result<void> MsgReader::read(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = takeUntil(text, "\n");
    text.remove_prefix(std::min<std::size_t>(1, text.size()));
    ++line_;
    if (const auto done = readLine(trimmed(line)); !done) return done;
  }
  return {};
}

Result<void> MsgReader::readLine(std::string_view line) {
  if (line.starts_with("==") && line.find_first_not_of('=') == std::string_view::npos) {
    isAfterSeparator_ = true;
    return {};
  }
  if (isAfterSeparator_ && line.starts_with("MSG:")) {
    const std::string_view name = trimmed(line.substr(4));
    if (!isTypeName(name)) return error("a type's name is expected after \"MSG:\"");
    isAfterSeparator_ = false;
    begin(std::string(name));
    return {};
  }
  if (line.empty() || line.starts_with('#')) return {};
  if (isAfterSeparator_) return error("\"MSG:\" and the name of a type are expected after a line of '='");
  return readField(line);
}

Result<void> MsgReader::readField(std::string_view line) {
  Field field;
  const std::string_view type = takeUntil(line, " \t");
  if (const auto read = readType(type, field); !read) return read;
  line = trimmed(line);
  field.name = takeUntil(line, " \t=#");
  if (!isName(field.name)) return error("a name is expected after the type \"" + std::string(type) + "\"");
  line = trimmed(line);
  if (line.starts_with('=')) {
    addConstant(field, field.name, trimmed(line.substr(1)));
    return {};
  }
  if (constants_.kind == field.kind && field.shape == Shape::kSingle)
    field.enumerators = std::move(constants_.values);
  constants_ = {};
  if (current_->fields.size() >= kMaxFields) return error("the message has too many fields");
  current_->fields.push_back(std::move(field));
  return {};
}

/// Only integers are of use: as the names of a field's values.
void MsgReader::addConstant(const Field& type, std::string_view name, std::string_view value) {
  if (type.shape != Shape::kSingle || !isEnumerable(type.kind)) return;
  if (constants_.kind != type.kind) constants_ = {type.kind, {}};
  const auto number = parsedNumber<std::int32_t>(trimmed(takeUntil(value, "#")));
  const auto isSame = [&](const auto& known) { return known.first == name; };
  if (number && std::ranges::none_of(constants_.values, isSame))
    constants_.values.emplace_back(name, *number);
}

Result<void> MsgReader::readType(std::string_view type, Field& field) const {
  std::string_view rest = type;
  const std::string_view name = takeUntil(rest, "[<");
  if (!isTypeName(name)) return error("a type is expected, not \"" + std::string(type) + "\"");
  if (const auto kind = builtin(name, version_)) {
    field.kind = *kind;
  } else {
    field.structName = name == "Header" ? "std_msgs/Header" : std::string(name);
  }
  if (rest.starts_with("<=") && (field.kind == Kind::kString || field.kind == Kind::kWstring)) {
    rest.remove_prefix(2);
    if (!parsedNumber<std::uint64_t>(takeUntil(rest, "[")))
      return error("the maximum length of a text is expected in \"" + std::string(type) + "\"");
  }
  return rest.empty() ? Result<void>() : readShape(rest, field);
}

/// "[]", "[8]", "[<=8]".
Result<void> MsgReader::readShape(std::string_view brackets, Field& field) const {
  const std::string given(brackets);
  if (brackets.size() < 2 || brackets.front() != '[' || brackets.back() != ']')
    return error("\"[]\" with or without a number is expected, not \"" + given + "\"");
  brackets = brackets.substr(1, brackets.size() - 2);
  field.shape = brackets.empty() || brackets.starts_with("<=") ? Shape::kSequence : Shape::kArray;
  if (brackets.empty()) return {};
  if (brackets.starts_with("<=")) brackets.remove_prefix(2);
  const auto count = parsedNumber<std::uint64_t>(brackets);
  if (!count) return error("a number is expected in \"" + given + "\"");
  field.count = *count;
  return {};
}

}  // namespace

Result<Definitions> readMsg(const std::string& name, std::string_view text, Version version) {
  MsgReader reader(name, version);
  if (const auto read = reader.read(text); !read) return tl::unexpected(read.error());
  return resolved(reader.structs(), structKey(name));
}

}  // namespace robotlink::ros
