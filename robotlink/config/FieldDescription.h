// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"

namespace robotlink {

/// A soccer field as read from a file like resources/fields/2002.yaml: the only source of its geometry and
/// colors for the simulator, the robot program and the views. Meters and radians; the origin is the center of
/// the field, +x points to the goal that the first team attacks, +y to the left. Colors are names in the
/// palette. Lengths of things that a field lacks are 0, their colors and lists empty. A plain value.
struct FieldDescription {
  /// A goal; goals share width, depth and height (see goalWidth).
  struct Goal {
    std::string name;
    /// The goal line's x; the goal extends from there away from the center.
    double x = 0;
    std::string color;
  };
  /// A colored pole beside the field that robots localize by: a base and two colored bands.
  struct Beacon {
    std::string name;
    /// The position on the ground.
    Vector2 position = Vector2::Zero();
    std::string topColor;
    std::string bottomColor;
  };
  /// A team that plays on the field.
  struct Team {
    std::string name;
    /// The name of the goal that it attacks, except where a game says otherwise.
    std::string attacks;
    /// The color of its robots.
    std::string color;
  };
  /// A named color of the file's palette.
  struct PaletteColor {
    std::string name;
    Rgb rgb;
  };

  std::string name;
  /// The surface inside the walls: -length/2 <= x <= length/2, -width/2 <= y <= width/2.
  double length = 0, width = 0;
  std::string surfaceColor;
  /// Coulomb's friction coefficient.
  double surfaceFriction = 1;
  /// How far the ground extends beyond the walls.
  double surroundingsMargin = 0;
  std::string surroundingsColor;
  /// The walls around the surface; 0 if there are none.
  double wallHeight = 0, wallThickness = 0;
  std::string wallColor;
  /// The sides along the walls of the ramps in the four corners; 0 if there are none.
  double cornerTriangleSide = 0;
  double lineWidth = 0, centerCircleDiameter = 0;
  /// The rectangle of lines around the field of play; 0 if the field has no such lines, and then the surface
  /// is the field of play.
  double boundaryLength = 0, boundaryWidth = 0;
  /// The length is along x, the width along y.
  double penaltyAreaLength = 0, penaltyAreaWidth = 0;
  std::string lineColor;
  /// The opening is goalWidth wide and goalHeight high.
  double goalWidth = 0, goalDepth = 0, goalHeight = 0;
  std::vector<Goal> goals;
  /// A beacon is a base and two bands of equal height.
  double beaconRadius = 0, beaconBaseHeight = 0, beaconBandHeight = 0;
  std::string beaconBaseColor;
  std::vector<Beacon> beacons;
  /// Kick-off positions of the team that plays toward +x, all in its own half (x < 0); the other team stands
  /// at the points mirrored through the center.
  std::vector<Pose2> kickOff;
  /// Files without teams, as in logs of before, have the teams red, toward +x, and blue.
  std::vector<Team> teams;
  double ballRadius = 0, ballMass = 0;  ///< m and kg
  std::string ballColor;
  /// In the file's order.
  std::vector<PaletteColor> palette;

  bool hasBoundary() const { return boundaryLength > 0; }
  /// Half the length of the field of play.
  double goalLineX() const { return 0.5 * (hasBoundary() ? boundaryLength : length); }
  /// Half the width of the field of play.
  double touchLineY() const { return 0.5 * (hasBoundary() ? boundaryWidth : width); }
  /// The height of the center of a beacon's lower band above the ground.
  double beaconBottomBandHeight() const { return beaconBaseHeight + 0.5 * beaconBandHeight; }
  double beaconTopBandHeight() const { return beaconBaseHeight + 1.5 * beaconBandHeight; }
  /// 1 if a team plays toward +x, -1 if toward -x. Unknown teams play toward +x.
  double playingDirection(std::string_view team) const;
  /// The color of a team's robots; gray if the team is unknown.
  Rgb teamColor(std::string_view team) const;
  /// The palette's color of this name; null if there is none.
  const Rgb* color(std::string_view colorName) const;

  /// Reads a file. Every problem is reported with its line; ids begin with "field.", "yaml." or "file.".
  static tl::expected<FieldDescription, Errors> load(const std::filesystem::path& file);
  /// Reads a text as load() reads a file; `file` is the name that errors carry.
  static tl::expected<FieldDescription, Errors> parse(std::string_view text, std::string file);
};

}  // namespace robotlink
