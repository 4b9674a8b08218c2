// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/RobotUse.h"

#include <algorithm>

#include "robotlink/config/RobotUseReader.h"

namespace robotlink {
namespace {

tl::expected<RobotUse, Errors> readUse(Result<YamlReader> reader) {
  if (!reader) return tl::unexpected(Errors{reader.error()});
  const YamlNode root = reader->root();
  root.entries();  // The keys that are not read here are the description's.
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

std::string RobotUse::teamOf(const std::string& robot) const {
  const auto found =
      std::find_if(teams.begin(), teams.end(), [&](const auto& team) { return robot.starts_with(team); });
  if (found != teams.end()) return *found;
  return teams.empty() ? std::string() : teams.front();
}

tl::expected<RobotUse, Errors> readRobotUse(const std::filesystem::path& file) {
  return readUse(YamlReader::load(file));
}

tl::expected<RobotUse, Errors> parseRobotUse(const std::string& text, const std::string& file) {
  return readUse(YamlReader::parse(text, file));
}

}  // namespace robotlink
