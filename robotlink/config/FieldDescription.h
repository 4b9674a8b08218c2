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

/// A field of play, as a file like resources/fields/2002.yaml describes it: the one source of its geometry
/// and colours for the simulator, the robot program and the views. Metres; the origin is the field's centre,
/// +x points to the opponent goal of the red team, +y to the left. A plain value. Colours are names of the
/// palette. What a field does not have is 0, empty or without a colour.
struct FieldDescription {
  struct Goal {
    std::string name;
    double x = 0;  ///< of the goal line; the goal lies beyond it
    std::string color;
  };
  struct Beacon {
    std::string name;
    Vector2 position = Vector2::Zero();
    std::string topColor;
    std::string bottomColor;
  };
  struct PaletteColor {
    std::string name;
    Rgb rgb;
  };

  std::string name;
  double length = 0, width = 0;  ///< of the surface inside the walls: -length/2 <= x <= length/2
  std::string surfaceColor;
  double surfaceFriction = 1;
  double surroundingsMargin = 0;  ///< how far the ground goes on beyond the walls
  std::string surroundingsColor;
  double wallHeight = 0, wallThickness = 0;
  std::string wallColor;
  double cornerTriangleSide = 0;
  double lineWidth = 0, centerCircleDiameter = 0;
  /// The size of the rectangle of lines around the field of play, or of the surface if there are no such
  /// lines.
  double boundaryLength = 0, boundaryWidth = 0;
  double penaltyAreaLength = 0, penaltyAreaWidth = 0;
  std::string lineColor;
  double goalWidth = 0, goalDepth = 0, goalHeight = 0;
  std::vector<Goal> goals;
  double beaconRadius = 0, beaconBaseHeight = 0, beaconBandHeight = 0;
  std::string beaconBaseColor;
  std::vector<Beacon> beacons;
  /// Where the robots of the team that plays towards +x stand at the kick-off; the other team stands
  /// opposite.
  std::vector<Pose2> kickOff;
  double ballRadius = 0, ballMass = 0;
  std::string ballColor;
  std::vector<PaletteColor> palette;  ///< in the file's order

  bool hasBoundary() const { return boundaryLength > 0; }
  /// How far from the centre the field of play goes.
  double goalLineX() const { return 0.5 * (hasBoundary() ? boundaryLength : length); }
  double touchLineY() const { return 0.5 * (hasBoundary() ? boundaryWidth : width); }
  /// Height of the middle of a beacon's lower and upper band.
  double beaconBottomBandHeight() const { return beaconBaseHeight + 0.5 * beaconBandHeight; }
  double beaconTopBandHeight() const { return beaconBaseHeight + 1.5 * beaconBandHeight; }
  /// A colour of the palette, or null.
  const Rgb* color(std::string_view colorName) const;

  static tl::expected<FieldDescription, Errors> load(const std::filesystem::path& file);
  static tl::expected<FieldDescription, Errors> parse(std::string_view text, std::string file);
};

}  // namespace robotlink
