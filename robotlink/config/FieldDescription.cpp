// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/FieldDescription.h"

#include <algorithm>
#include <cmath>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/YamlReader.h"

namespace robotlink {
namespace {

/// Reads a length on a field: between a millimeter and a hundred meters.
double lengthOf(const YamlNode& node, std::string_view key) {
  return node.numberIn(key, 0.001, 100);
}

void readPalette(const YamlNode& node, FieldDescription& field) {
  for (const auto& [name, value] : node.entries()) {
    const auto channels = value.as<std::vector<int>>();
    const bool valid =
        channels.size() == 3 && std::ranges::all_of(channels, [](int c) { return c >= 0 && c <= 255; });
    if (!valid) {
      value.fail("field.color", "a color is three whole numbers from 0 to 255: [red, green, blue]", {name});
      continue;
    }
    const auto channel = [&](std::size_t i) { return static_cast<std::uint8_t>(channels[i]); };
    field.palette.push_back({name, {channel(0), channel(1), channel(2)}});
  }
}

/// Reads the required name of a color, which must be in the palette.
std::string colorOf(const YamlNode& node, std::string_view key, const FieldDescription& field) {
  const YamlNode child = node.child(key);
  auto name = child.as<std::string>();
  if (!child.empty() && field.color(name) == nullptr) {
    child.fail("field.unknown-color", "the palette has no color '" + name + "'", {name});
  }
  return name;
}

void readGround(const YamlNode& root, FieldDescription& field) {
  const YamlNode surface = root.child("surface");
  field.length = lengthOf(surface, "length");
  field.width = lengthOf(surface, "width");
  field.surfaceColor = colorOf(surface, "color", field);
  field.surfaceFriction = surface.numberIn("friction", 0, 10);
  const YamlNode surroundings = root.child("surroundings");
  field.surroundingsMargin = surroundings.numberIn("margin", 0, 100);
  field.surroundingsColor = colorOf(surroundings, "color", field);
  if (const YamlNode walls = root.optionalChild("walls"); !walls.empty()) {
    field.wallHeight = lengthOf(walls, "height");
    field.wallThickness = lengthOf(walls, "thickness");
    field.wallColor = colorOf(walls, "color", field);
  }
  if (const YamlNode triangles = root.optionalChild("corner_triangles"); !triangles.empty())
    field.cornerTriangleSide = lengthOf(triangles, "side");
}

void readLines(const YamlNode& lines, FieldDescription& field) {
  field.lineWidth = lengthOf(lines, "width");
  field.lineColor = colorOf(lines, "color", field);
  field.centerCircleDiameter = lengthOf(lines, "center_circle_diameter");
  if (const YamlNode boundary = lines.optionalChild("boundary"); !boundary.empty()) {
    field.boundaryLength = boundary.numberIn("length", 0.001, field.length);
    field.boundaryWidth = boundary.numberIn("width", 0.001, field.width);
  }
  field.penaltyAreaLength = lengthOf(lines.child("penalty_area"), "length");
  field.penaltyAreaWidth = lengthOf(lines.child("penalty_area"), "width");
}

void readGoals(const YamlNode& root, FieldDescription& field) {
  const YamlNode goal = root.child("goal");
  field.goalWidth = lengthOf(goal, "width");
  field.goalDepth = lengthOf(goal, "depth");
  field.goalHeight = lengthOf(goal, "height");
  for (const YamlNode& node : root.child("goals").items()) {
    field.goals.push_back(
        {node.required<std::string>("name"), node.numberIn("x", -100, 100), colorOf(node, "color", field)});
  }
}

void readBeacons(const YamlNode& root, FieldDescription& field) {
  const YamlNode beacon = root.optionalChild("beacon");
  if (beacon.empty()) return;
  field.beaconRadius = lengthOf(beacon, "radius");
  field.beaconBaseHeight = lengthOf(beacon, "base_height");
  field.beaconBandHeight = lengthOf(beacon, "band_height");
  field.beaconBaseColor = colorOf(beacon, "base_color", field);
  for (const YamlNode& node : root.child("beacons").items()) {
    const auto position = node.numbers("position", 2);
    field.beacons.push_back({node.required<std::string>("name"), Vector2(position[0], position[1]),
                             colorOf(node, "top", field), colorOf(node, "bottom", field)});
  }
}

void readKickOff(const YamlNode& root, FieldDescription& field) {
  const YamlNode places = root.optionalChild("kick_off");
  if (places.empty()) return;
  for (const YamlNode& place : places.items()) {
    const auto numbers = place.as<std::vector<double>>();
    const bool inOwnHalf = numbers.size() == 2 && numbers[0] < 0 && numbers[0] > -0.5 * field.length &&
                           std::abs(numbers[1]) < 0.5 * field.width;
    if (inOwnHalf) {
      field.kickOff.push_back({numbers[0], numbers[1], 0});
    } else {
      place.fail("field.kick-off",
                 "a place at the kick-off is [x, y] in the half of the team that plays toward +x, where x is "
                 "negative");
    }
  }
}

void readTeams(const YamlNode& root, FieldDescription& field) {
  const YamlNode teams = root.optionalChild("teams");
  if (teams.empty()) {
    const auto goalToward = [&field](double direction) {
      const auto goal =
          std::ranges::find_if(field.goals, [&](const auto& each) { return each.x * direction > 0; });
      return goal == field.goals.end() ? std::string() : goal->name;
    };
    field.teams = {{"red", goalToward(1), "red"}, {"blue", goalToward(-1), "blue"}};
    return;
  }
  for (const YamlNode& node : teams.items()) {
    FieldDescription::Team team{node.required<std::string>("name"), node.required<std::string>("attacks"),
                                colorOf(node, "color", field)};
    if (std::ranges::find(field.goals, team.attacks, &FieldDescription::Goal::name) == field.goals.end())
      node.fail("field.team", "the team attacks '" + team.attacks + "', which is not one of the goals");
    field.teams.push_back(std::move(team));
  }
}

tl::expected<FieldDescription, Errors> readField(YamlReader& yaml) {
  const YamlNode root = yaml.root();
  FieldDescription field;
  if (root.required<int>("version") != 1)
    root.fail("field.version", "only version 1 of this format is supported");
  field.name = root.required<std::string>("name");
  readPalette(root.child("palette"), field);
  readGround(root, field);
  readLines(root.child("lines"), field);
  readGoals(root, field);
  readTeams(root, field);
  readBeacons(root, field);
  readKickOff(root, field);
  const YamlNode ball = root.child("ball");
  field.ballRadius = lengthOf(ball, "radius");
  field.ballMass = ball.numberIn("mass", 1e-4, 100);
  field.ballColor = colorOf(ball, "color", field);
  if (auto finished = yaml.finish(); !finished) return tl::unexpected(std::move(finished.error()));
  return field;
}

}  // namespace

double FieldDescription::playingDirection(std::string_view team) const {
  const auto found = std::ranges::find(teams, team, &Team::name);
  if (found == teams.end()) return 1;
  const auto goal = std::ranges::find(goals, found->attacks, &Goal::name);
  return goal != goals.end() && goal->x < 0 ? -1 : 1;
}

Rgb FieldDescription::teamColor(std::string_view team) const {
  constexpr Rgb kGray{128, 128, 128};
  const auto found = std::ranges::find(teams, team, &Team::name);
  const Rgb* rgb = found == teams.end() ? nullptr : color(found->color);
  return rgb == nullptr ? kGray : *rgb;
}

const Rgb* FieldDescription::color(std::string_view colorName) const {
  const auto found = std::ranges::find(palette, colorName, &PaletteColor::name);
  return found == palette.end() ? nullptr : &found->rgb;
}

tl::expected<FieldDescription, Errors> FieldDescription::parse(std::string_view text, std::string file) {
  auto yaml = YamlReader::parse(text, std::move(file));
  if (!yaml) return tl::unexpected(Errors{yaml.error()});
  return readField(*yaml);
}

tl::expected<FieldDescription, Errors> FieldDescription::load(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(Errors{text.error()});
  return parse(*text, file.string());
}

}  // namespace robotlink
