// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/RobotSet.h"

#include <nlohmann/json.hpp>
#include <set>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/YamlReader.h"
#include "robotlink/foxglove/client/ServerUrl.h"

namespace app {
namespace {

using robotlink::Errors;
using robotlink::YamlNode;

constexpr int kSetVersion = 1;
constexpr std::size_t kMaxSetBytes = 1U << 20U;

RobotSet::Robot readSetRobot(const YamlNode& node) {
  RobotSet::Robot robot;
  const YamlNode name = node.child("name");
  robot.name = name.as<std::string>();
  if (robot.name.empty()) name.fail("robots.name", "a robot needs a name, the one that its program uses");
  robot.team = node.optional<std::string>("team", {});
  robot.role = node.optional<std::string>("role", {});
  const YamlNode address = node.child("address");
  robot.address = address.as<std::string>();
  if (const auto url = robotlink::websocket::parseServerUrl(robot.address); !url)
    address.fail("robots.address", url.error().text, {robot.address});
  robot.layout = node.optional<std::string>("layout", {});
  robot.colorTable = node.optional<std::string>("color-table", {});
  robot.parameters = node.optional<std::string>("parameters", {});
  robot.motions = node.optional<std::string>("motions", {});
  robot.preset = node.optional<std::string>("preset", {});
  return robot;
}

/// In quotes, which YAML reads as JSON has them.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

tl::expected<RobotSet, Errors> parseRobotSet(std::string_view text, const std::string& file) {
  auto reader = robotlink::YamlReader::parse(text, file);
  if (!reader) return tl::unexpected(Errors{reader.error()});
  const YamlNode root = reader->root();
  RobotSet set;
  const YamlNode version = root.child("robot-set");
  if (const int number = version.as<int>(); !version.empty() && number != kSetVersion)
    version.fail("robots.version", "this program only reads version 1 of these files; get a newer program");
  set.name = root.required<std::string>("name");
  std::set<std::string> names;
  for (const YamlNode& node : root.child("robots").items()) {
    RobotSet::Robot robot = readSetRobot(node);
    if (!names.insert(robot.name).second)
      node.fail("robots.twice", "there is another robot '" + robot.name + "' in this set", {robot.name});
    set.robots.push_back(std::move(robot));
  }
  if (auto finished = reader->finish(); !finished) return tl::unexpected(finished.error());
  return set;
}

tl::expected<RobotSet, Errors> readRobotSet(const std::filesystem::path& file) {
  const auto text = robotlink::readFile(file, kMaxSetBytes);
  if (!text) return tl::unexpected(Errors{text.error()});
  return parseRobotSet(*text, file.string());
}

std::string toText(const RobotSet& set) {
  std::string text = "# Robots that are connected and set up together, by RobotControl or robotctl deploy.\n";
  text += "robot-set: " + std::to_string(kSetVersion) + "\nname: " + quoted(set.name) + "\nrobots:";
  if (set.robots.empty()) return text + " []\n";
  for (const RobotSet::Robot& robot : set.robots) {
    text += "\n  - name: " + quoted(robot.name) + "\n";
    const auto add = [&](const char* key, const std::string& value) {
      if (!value.empty()) text += std::string("    ") + key + ": " + quoted(value) + "\n";
    };
    add("team", robot.team);
    add("role", robot.role);
    text += "    address: " + quoted(robot.address) + "\n";
    add("layout", robot.layout);
    add("color-table", robot.colorTable);
    add("parameters", robot.parameters);
    add("motions", robot.motions);
    add("preset", robot.preset);
    text.pop_back();
  }
  return text + "\n";
}

}  // namespace app
