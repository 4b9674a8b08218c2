// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/Resolution.h"

#include <algorithm>
#include <optional>

namespace robotlink::ros {
namespace {

constexpr char kError[] = "ros.definition";

/// Follows the structs from the root on, each once.
class Walk {
 public:
  explicit Walk(const std::map<std::string, Struct>& parsed) : parsed_(parsed) {}

  /// Resolves a struct that `depth` others contain. Returns how many levels it has.
  Result<int> visit(const std::string& name, int depth);
  std::map<std::string, Struct> take() { return std::move(done_); }

 private:
  Result<int> visit(const std::string& owner, Field& field, int depth);
  std::optional<std::string> find(const std::string& owner, const std::string& written) const;

  const std::map<std::string, Struct>& parsed_;
  std::map<std::string, Struct> done_;
  /// The levels of those that are done.
  std::map<std::string, int> levels_;
  std::size_t fields_ = 0;
};

/// Sets the kind of a struct that every decoder knows.
bool setTime(Field& field) {
  const std::string key = structKey(field.structName);
  if (key != "builtin_interfaces/Time" && key != "builtin_interfaces/Duration") return false;
  field.kind = key.ends_with("Time") ? Kind::kTime : Kind::kDuration;
  field.structName.clear();
  return true;
}

std::optional<std::string> Walk::find(const std::string& owner, const std::string& written) const {
  const std::string key = structKey(written);
  if (key.find('/') != std::string::npos) return parsed_.contains(key) ? std::optional(key) : std::nullopt;
  const std::string beside = owner.substr(0, owner.rfind('/') + 1) + key;
  if (parsed_.contains(beside)) return beside;
  // Some writers leave the package out: the name is enough if only one package has it.
  std::optional<std::string> found;
  for (const auto& [name, definition] : parsed_) {
    if (!name.ends_with("/" + key)) continue;
    if (found) return std::nullopt;
    found = name;
  }
  return found;
}

Result<int> Walk::visit(const std::string& owner, Field& field, int depth) {
  if (field.kind != Kind::kStruct || setTime(field)) return 0;
  const auto key = find(owner, field.structName);
  if (!key) {
    return failure(kError,
                   owner + "." + field.name + " is a " + field.structName + ", which is not defined here", {},
                   {owner, field.name, field.structName});
  }
  field.structName = *key;
  return visit(*key, depth + 1);
}

Result<int> Walk::visit(const std::string& name, int depth) {
  const auto known = levels_.find(name);
  // A struct that contains itself ends here, too.
  if (depth + (known == levels_.end() ? 0 : known->second) >= kMaxDepth)
    return failure(kError, name + " is nested too deeply, or contains itself", {}, {name});
  if (known != levels_.end()) return known->second;
  Struct definition = parsed_.at(name);
  fields_ += definition.fields.size();
  if (fields_ > kMaxFields) return failure(kError, "the message has too many fields", {}, {name});
  int levels = 0;
  for (Field& field : definition.fields) {
    const auto inner = visit(name, field, depth);
    if (!inner) return inner;
    levels = std::max(levels, *inner);
  }
  done_[name] = std::move(definition);
  return levels_[name] = levels + 1;
}

}  // namespace

Result<Definitions> resolved(const std::map<std::string, Struct>& parsed, const std::string& root) {
  if (!parsed.contains(root)) return failure(kError, root + " is not defined here", {}, {root});
  Walk walk(parsed);
  if (const auto visited = walk.visit(root, 0); !visited) return tl::unexpected(visited.error());
  return Definitions{root, walk.take()};
}

}  // namespace robotlink::ros
