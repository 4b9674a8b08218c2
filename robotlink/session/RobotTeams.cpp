// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/RobotTeams.h"

#include <algorithm>

#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"

namespace robotlink {
namespace {

/// Empty if it has none, or none is known.
std::string presentTeam(Session& session, const std::string& robot) {
  return teamOf(session.store(), robot, session.timeline().newest()).value_or("");
}

}  // namespace

std::optional<std::string> teamOf(const StreamStore& store, const std::string& robot, Instant shown) {
  const auto* objects = store.latestAs<robotcontrol::WorldObjects>(streams::kObjects, shown);
  if (objects == nullptr) return std::nullopt;
  const auto object = std::ranges::find(objects->objects(), robot, &robotcontrol::WorldObject::path);
  if (object == objects->objects().end()) return std::nullopt;
  const auto team = std::ranges::find(object->properties(), "team", &robotcontrol::WorldProperty::name);
  return team == object->properties().end() ? std::nullopt : std::optional(team->text());
}

std::vector<std::string> teamNames(Session& session) {
  std::vector<std::string> names;
  for (const std::string& robot : session.robots()) {
    std::string team = presentTeam(session, robot);
    if (!team.empty() && std::ranges::find(names, team) == names.end()) names.push_back(std::move(team));
  }
  return names;
}

std::vector<std::string> robotAndTeamNames(Session& session) {
  std::vector<std::string> names = session.robots();
  for (std::string& team : teamNames(session)) names.push_back(std::move(team));
  return names;
}

std::vector<std::string> robotsOfTeam(Session& session, const std::string& team) {
  std::vector<std::string> robots;
  for (const std::string& robot : session.robots()) {
    if (!team.empty() && presentTeam(session, robot) == team) robots.push_back(robot);
  }
  return robots;
}

std::vector<std::string> robotsNamed(Session& session, const std::string& name) {
  const auto& all = session.robots();
  return std::ranges::find(all, name) != all.end() ? std::vector{name} : robotsOfTeam(session, name);
}

}  // namespace robotlink
