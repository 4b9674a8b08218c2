// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/RobotUseReader.h"

namespace robotlink {
namespace {

/// Makes all keys of a node known, however deep.
void know(const YamlNode& node) {
  if (node.isMap()) {
    for (const auto& [key, value] : node.entries()) know(value);
  } else if (node.isList()) {
    for (const YamlNode& item : node.items()) know(item);
  }
}

tl::expected<RobotUse, Errors> readAll(Result<YamlReader> reader) {
  if (!reader) return tl::unexpected(Errors{reader.error()});
  const YamlNode root = reader->root();
  know(root);  // The keys that are not read here are the description's.
  RobotUse use = readRobotUse(root);
  if (auto finished = reader->finish(); !finished) return tl::unexpected(finished.error());
  return use;
}

}  // namespace

RobotUse readRobotUse(const YamlNode& root) {
  RobotUse use;
  use.field = root.optional<std::string>("field", "");
  if (use.field.find('/') != std::string::npos)
    root.fail("robot.field", "field is the name of a file in resources/fields, without a folder");
  use.teams = root.optional<std::vector<std::string>>("teams", {});
  return use;
}

tl::expected<RobotUse, Errors> readRobotUse(const std::filesystem::path& file) {
  return readAll(YamlReader::load(file));
}

tl::expected<RobotUse, Errors> parseRobotUse(const std::string& text, const std::string& file) {
  return readAll(YamlReader::parse(text, file));
}

}  // namespace robotlink
