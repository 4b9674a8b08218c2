// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/IdlReader.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/ros/IdlTokens.h"
#include "robotlink/ros/Resolution.h"

namespace robotlink::ros {
namespace {

/// Typedefs of typedefs.
constexpr int kMaxAliases = 64;

/// A field whose type may be a name that is defined later.
struct Member {
  Field field;
  /// Empty: the field's kind is known.
  std::string typeName;
  /// The modules in which it is used, with "::" behind each.
  std::string scope;
};

const std::map<std::string_view, Kind>& basicTypes() {
  static const std::map<std::string_view, Kind> kTypes{
      {"boolean", Kind::kBool},  {"octet", Kind::kUint8},    {"char", Kind::kUint8},
      {"wchar", Kind::kUint16},  {"int8", Kind::kInt8},      {"uint8", Kind::kUint8},
      {"int16", Kind::kInt16},   {"uint16", Kind::kUint16},  {"int32", Kind::kInt32},
      {"uint32", Kind::kUint32}, {"int64", Kind::kInt64},    {"uint64", Kind::kUint64},
      {"short", Kind::kInt16},   {"float", Kind::kFloat32},  {"double", Kind::kFloat64},
      {"string", Kind::kString}, {"wstring", Kind::kWstring}};
  return kTypes;
}

/// "Header", "std_msgs::msg::Header".
bool isScopedName(std::string_view token) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == ':'; };
  return !token.empty() && std::isdigit(static_cast<unsigned char>(token[0])) == 0 &&
         std::ranges::all_of(token, fits);
}

/// Reads the declarations one after the other, then resolves the names of types.
class IdlReader {
 public:
  IdlReader(const std::string& name, std::string_view text) : name_(name), tokens_(text) {}
  Result<std::map<std::string, Struct>> read();

 private:
  Result<void> readDeclaration();
  Result<void> readStruct();
  Result<void> readMembers(std::vector<Member>& to, bool isTypedef);
  Result<void> readEnumeration();
  Result<void> readConstant();
  Result<Member> readType();
  Result<void> readBasicType(Member& to);
  Result<void> readSequence(Member& to);
  Result<void> readDimensions(Member& to);
  Result<std::uint64_t> readSize();
  /// Skips annotations; keeps the number of @value.
  Result<void> skipAnnotations();
  Result<void> resolve(Member& member) const;
  const std::string* findName(const Member& member) const;

  Result<void> expect(std::string_view token) {
    if (tokens_.take(token)) return {};
    return error("\"" + std::string(token) + "\" is expected");
  }
  Result<std::string> takeName() {
    if (!isScopedName(tokens_.current())) return error("a name is expected");
    return std::string(tokens_.take());
  }
  tl::unexpected<Error> error(const std::string& text) const {
    const std::string found(tokens_.current().substr(0, 40));
    return failure("ros.definition", text + ", not \"" + found + "\"", {name_, tokens_.line(), 0});
  }
  std::string scope() const {
    std::string text;
    for (const std::string& module : modules_) text += module + "::";
    return text;
  }

  const std::string& name_;
  IdlTokens tokens_;
  std::vector<std::string> modules_;
  // Keyed by full names, with "::".
  std::map<std::string, std::vector<Member>> structs_;
  std::map<std::string, Member> aliases_;
  std::map<std::string, std::uint64_t> constants_;
  /// All of them but constants.
  std::map<std::string, std::string> names_;
  std::optional<std::int32_t> annotatedValue_;
  std::size_t fields_ = 0;
};

Result<std::map<std::string, Struct>> IdlReader::read() {
  while (!tokens_.current().empty()) {
    if (const auto read = readDeclaration(); !read) return tl::unexpected(read.error());
  }
  if (!modules_.empty()) return error("\"}\" is expected");
  std::map<std::string, Struct> structs;
  for (auto& [name, members] : structs_) {
    Struct& definition = structs[structKey(name)];
    for (Member& member : members) {
      if (const auto found = resolve(member); !found) return tl::unexpected(found.error());
      definition.fields.push_back(std::move(member.field));
    }
  }
  return structs;
}

Result<void> IdlReader::readDeclaration() {
  if (const auto skipped = skipAnnotations(); !skipped) return skipped;
  if (!modules_.empty() && tokens_.take("}")) {
    modules_.pop_back();
    return expect(";");
  }
  if (tokens_.take("module")) {
    auto name = takeName();
    if (!name) return tl::unexpected(name.error());
    if (modules_.size() >= kMaxDepth) return error("modules are nested too deeply");
    modules_.push_back(std::move(*name));
    return expect("{");
  }
  if (tokens_.take("struct")) return readStruct();
  if (tokens_.take("enum")) return readEnumeration();
  if (tokens_.take("const")) return readConstant();
  if (tokens_.take("typedef")) {
    std::vector<Member> members;
    if (const auto read = readMembers(members, true); !read) return read;
    for (Member& member : members) {
      const std::string name = member.scope + member.field.name;
      names_[name] = name;
      aliases_[name] = std::move(member);
    }
    return {};
  }
  if (tokens_.take(";")) return {};
  return error("a module, struct, enum, typedef or const is expected");
}

Result<void> IdlReader::readStruct() {
  const auto name = takeName();
  if (!name) return tl::unexpected(name.error());
  if (tokens_.take(";")) return {};  // the struct is only declared
  if (const auto brace = expect("{"); !brace) return brace;
  const std::string fullName = scope() + *name;
  names_[fullName] = fullName;
  std::vector<Member> members;
  while (!tokens_.take("}")) {
    if (const auto read = readMembers(members, false); !read) return read;
    if (members.size() > kMaxFields) return error("the struct has too many fields");
  }
  structs_[fullName] = std::move(members);
  return expect(";");
}

/// "double x, y[3];"
Result<void> IdlReader::readMembers(std::vector<Member>& to, bool isTypedef) {
  if (const auto skipped = skipAnnotations(); !skipped) return skipped;
  const auto type = readType();
  if (!type) return tl::unexpected(type.error());
  do {
    Member member = *type;
    auto name = takeName();
    if (!name) return tl::unexpected(name.error());
    member.field.name = std::move(*name);
    member.scope = scope();
    if (const auto read = readDimensions(member); !read) return read;
    if (!isTypedef && ++fields_ > kMaxFields) return error("there are too many fields");
    to.push_back(std::move(member));
  } while (tokens_.take(","));
  return expect(";");
}

Result<void> IdlReader::readEnumeration() {
  const auto name = takeName();
  if (!name) return tl::unexpected(name.error());
  if (const auto brace = expect("{"); !brace) return brace;
  Member member;
  member.field.kind = Kind::kUint32;
  std::int32_t next = 0;
  do {
    if (const auto skipped = skipAnnotations(); !skipped) return skipped;
    const auto value = takeName();
    if (!value) return tl::unexpected(value.error());
    const std::int32_t number = annotatedValue_.value_or(next);
    next = number < std::numeric_limits<std::int32_t>::max() ? number + 1 : number;
    const auto isSame = [&](const auto& known) { return known.first == *value; };
    if (std::ranges::none_of(member.field.enumerators, isSame))
      member.field.enumerators.emplace_back(*value, number);
    if (member.field.enumerators.size() > kMaxFields) return error("there are too many names of values");
  } while (tokens_.take(",") && tokens_.current() != "}");
  const std::string fullName = scope() + *name;
  names_[fullName] = fullName;
  aliases_[fullName] = std::move(member);
  if (const auto brace = expect("}"); !brace) return brace;
  return expect(";");
}

/// Only natural numbers are of use: as sizes.
Result<void> IdlReader::readConstant() {
  const auto type = readType();
  if (!type) return tl::unexpected(type.error());
  const auto name = takeName();
  if (!name) return tl::unexpected(name.error());
  if (const auto sign = expect("="); !sign) return sign;
  if (const auto value = parsedNumber<std::uint64_t>(tokens_.current())) constants_[scope() + *name] = *value;
  while (tokens_.current() != ";" && !tokens_.current().empty()) tokens_.take();
  return expect(";");
}

Result<Member> IdlReader::readType() {
  Member member;
  Result<void> read;
  if (tokens_.take("sequence")) {
    read = readSequence(member);
  } else {
    read = readBasicType(member);
  }
  if (!read) return tl::unexpected(read.error());
  return member;
}

Result<void> IdlReader::readBasicType(Member& to) {
  if (tokens_.take("unsigned")) {
    to.field.kind = tokens_.take("short") ? Kind::kUint16 : Kind::kUint32;
    if (to.field.kind == Kind::kUint16) return {};
    if (const auto word = expect("long"); !word) return word;
    if (tokens_.take("long")) to.field.kind = Kind::kUint64;
    return {};
  }
  if (tokens_.take("long")) {
    if (tokens_.current() == "double") return error("numbers may have at most 64 bits");
    to.field.kind = tokens_.take("long") ? Kind::kInt64 : Kind::kInt32;
    return {};
  }
  auto name = takeName();
  if (!name) return tl::unexpected(name.error());
  const auto basic = basicTypes().find(*name);
  if (basic == basicTypes().end()) {
    to.typeName = std::move(*name);
    return {};
  }
  to.field.kind = basic->second;
  const bool isText = to.field.kind == Kind::kString || to.field.kind == Kind::kWstring;
  if (!isText || !tokens_.take("<")) return {};
  if (const auto size = readSize(); !size) return tl::unexpected(size.error());
  return expect(">");
}

Result<void> IdlReader::readSequence(Member& to) {
  if (const auto open = expect("<"); !open) return open;
  if (tokens_.current() == "sequence")
    return error("a sequence of lists is not read: another type is expected");
  if (const auto type = readBasicType(to); !type) return type;
  to.field.shape = Shape::kSequence;
  if (tokens_.take(",")) {
    const auto size = readSize();
    if (!size) return tl::unexpected(size.error());
    to.field.count = *size;
  }
  return expect(">");
}

Result<void> IdlReader::readDimensions(Member& to) {
  while (tokens_.take("[")) {
    const auto size = readSize();
    if (!size) return tl::unexpected(size.error());
    if (to.field.shape == Shape::kSequence)
      return error("an array of sequences is not read: \";\" is expected");
    constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();
    to.field.count = to.field.shape == Shape::kSingle
                         ? std::min(*size, kMax)
                         : std::min(to.field.count * std::min(*size, kMax), kMax);
    to.field.shape = Shape::kArray;
    if (const auto close = expect("]"); !close) return close;
  }
  return {};
}

Result<std::uint64_t> IdlReader::readSize() {
  if (const auto number = parsedNumber<std::uint64_t>(tokens_.current())) {
    tokens_.take();
    return *number;
  }
  const std::string name(tokens_.current());
  for (const std::string& full : {scope() + name, name}) {
    const auto constant = constants_.find(full);
    if (constant == constants_.end()) continue;
    tokens_.take();
    return constant->second;
  }
  return error("a number is expected");
}

Result<void> IdlReader::skipAnnotations() {
  annotatedValue_.reset();
  while (tokens_.take("@")) {
    if (tokens_.current() == "optional")
      return error("optional members are not read: another one is expected");
    const bool isValue = tokens_.take() == "value";
    if (!tokens_.take("(")) continue;
    if (isValue) annotatedValue_ = parsedNumber<std::int32_t>(tokens_.current());
    for (int depth = 1; depth > 0;) {
      const std::string_view token = tokens_.take();
      if (token.empty()) return error("\")\" is expected");
      depth += token == "(" ? 1 : token == ")" ? -1 : 0;
    }
  }
  return {};
}

/// From the innermost module outwards.
const std::string* IdlReader::findName(const Member& member) const {
  std::string_view name = member.typeName;
  if (name.starts_with("::")) name.remove_prefix(2);
  for (std::string around = member.scope;;) {
    const auto found = names_.find(around + std::string(name));
    if (found != names_.end()) return &found->second;
    if (around.empty()) return nullptr;
    around.resize(around.size() - 2);
    const auto at = around.rfind("::");
    around.resize(at == std::string::npos ? 0 : at + 2);
  }
}

/// Replaces the name of a type by the type that it is an alias of.
Result<void> IdlReader::resolve(Member& member) const {
  for (int aliases = 0; !member.typeName.empty(); ++aliases) {
    const std::string* name = findName(member);
    const auto alias = name == nullptr ? aliases_.end() : aliases_.find(*name);
    if (alias == aliases_.end()) {
      member.field.structName = structKey(name == nullptr ? member.typeName : *name);
      member.typeName.clear();
      return {};
    }
    const Member& meant = alias->second;
    if (aliases > kMaxAliases ||
        (meant.field.shape != Shape::kSingle && member.field.shape != Shape::kSingle))
      return failure("ros.definition", member.field.name + " is a list of lists, or has no type",
                     {name_, 0, 0}, {member.field.name});
    if (meant.field.shape != Shape::kSingle) {
      member.field.shape = meant.field.shape;
      member.field.count = meant.field.count;
    }
    member.field.kind = meant.field.kind;
    if (member.field.shape == Shape::kSingle) member.field.enumerators = meant.field.enumerators;
    member.typeName = meant.typeName;
    member.scope = meant.scope;
  }
  return {};
}

}  // namespace

Result<Definitions> readIdl(const std::string& name, std::string_view text) {
  const auto structs = IdlReader(name, text).read();
  if (!structs) return tl::unexpected(structs.error());
  return resolved(*structs, structKey(name));
}

}  // namespace robotlink::ros
