// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/FieldModel.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace app {
namespace {

using robotlink::FieldDescription;
using robotlink::kPi;

/// Thickness of the lines above the surface, m, so that the two do not flicker.
constexpr double kLineHeight = 0.0005;
/// The number of straight pieces of the center circle.
constexpr int kCirclePieces = 24;
/// Thickness of the goals' panels and of the floor, m.
constexpr double kGoalPanel = 0.02;
constexpr double kFloorDepth = 0.02;

/// Where a shape is in the field's frame; m, rad.
struct Pose {
  double x = 0, y = 0, z = 0, yaw = 0;
};

/// Writes all shapes into one static link.
class ModelWriter {
 public:
  ModelWriter(const FieldDescription& field, const std::string& name) : field_(field), name_(name) {}

  std::string write() {
    text_ =
        "<?xml version=\"1.0\"?>\n<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n"
        "<!-- Generated from a field's description in resources/fields: change that, not this file. -->\n"
        "<sdf version=\"1.9\" xmlns:robotcontrol=\"urn:robotcontrol:sdf\">\n"
        "  <model name=\"field\">\n    <static>true</static>\n    <robotcontrol:field>" +
        name_ + "</robotcontrol:field>\n";
    palette();
    homes();
    text_ += "    <link name=\"field\">\n";
    ground();
    lines();
    walls();
    corners();
    for (const FieldDescription::Goal& goal : field_.goals) goalPanels(goal);
    for (const FieldDescription::Beacon& beacon : field_.beacons) beaconBands(beacon);
    text_ += "    </link>\n  </model>\n</sdf>\n";
    return text_;
  }

 private:
  /// Turns "-0" into "0", which is the same but for text comparisons.
  static double tidy(double value) { return std::abs(value) < 1e-9 ? 0.0 : value; }

  /// Writes a visual or a collision; `rest` is what follows the geometry.
  void shape(const char* element, const std::string& name, const Pose& pose, const std::string& geometry,
             const std::string& rest) {
    text_ += fmt::format(
        "      <{0} name=\"{1}\"><pose>{2:.6g} {3:.6g} {4:.6g} 0 0 "
        "{5:.6g}</pose><geometry>{6}</geometry>{7}</{0}>\n",
        element, name, tidy(pose.x), tidy(pose.y), tidy(pose.z), tidy(pose.yaw), geometry, rest);
  }

  /// Writes a shape that can only be seen.
  void picture(const std::string& name, const Pose& pose, const std::string& geometry,
               const std::string& color, bool shadow = true) {
    const std::string casts = shadow ? "" : "<cast_shadows>false</cast_shadows>";
    shape("visual", name, pose, geometry, casts + "<robotcontrol:color>" + color + "</robotcontrol:color>");
  }

  static std::string box(double x, double y, double z) {
    return fmt::format("<box><size>{:.6g} {:.6g} {:.6g}</size></box>", x, y, z);
  }
  static std::string cylinder(double radius, double length) {
    return fmt::format("<cylinder><radius>{:.6g}</radius><length>{:.6g}</length></cylinder>", radius, length);
  }

  /// Writes a shape that can be seen and touched.
  void solid(const std::string& name, const Pose& pose, const std::string& geometry,
             const std::string& color) {
    shape("collision", name, pose, geometry, "");
    picture(name, pose, geometry, color);
  }

  void palette() {
    text_ += "    <robotcontrol:palette>\n";
    for (const auto& [name, rgb] : field_.palette) {
      text_ += fmt::format("      <robotcontrol:color name=\"{}\">{} {} {}</robotcontrol:color>\n", name,
                           rgb.r, rgb.g, rgb.b);
    }
    text_ += "    </robotcontrol:palette>\n";
  }

  /// Writes where the robots of each team stand at the kick-off; the teams are opposite each other.
  void homes() {
    for (const auto& [team, turn] : {std::pair("red", 0.0), std::pair("blue", kPi)}) {
      for (const robotlink::Pose2& place : field_.kickOff) {
        const robotlink::Pose2 home = robotlink::Pose2{0, 0, turn} * place;
        text_ += fmt::format("    <robotcontrol:home team=\"{}\">{:.6g} {:.6g} {:.6g}</robotcontrol:home>\n",
                             team, tidy(home.x), tidy(home.y), tidy(home.heading));
      }
    }
  }

  void ground() {
    const std::string friction = fmt::format(
        "<surface><friction><ode><mu>{:.6g}</mu></ode></friction></surface>", field_.surfaceFriction);
    const double length = field_.length + 2 * field_.wallThickness,
                 width = field_.width + 2 * field_.wallThickness;
    const double margin = 2 * field_.surroundingsMargin;
    shape("collision", "ground", {}, "<plane><normal>0 0 1</normal><size>20 20</size></plane>", friction);
    picture("surface", {0, 0, -kFloorDepth / 2, 0}, box(length, width, kFloorDepth), field_.surfaceColor,
            false);
    if (margin <= 0) return;
    picture("surroundings", {0, 0, -kFloorDepth, 0}, box(length + margin, width + margin, kFloorDepth),
            field_.surroundingsColor, false);
  }

  /// Writes a field line, `length` along x and `width` along y before it is turned by the yaw.
  void line(const std::string& name, const Pose& pose, double length, double width) {
    picture("line_" + name, {pose.x, pose.y, kLineHeight / 2, pose.yaw}, box(length, width, kLineHeight),
            field_.lineColor, false);
  }

  void lines() {
    const double w = field_.lineWidth;
    line("halfway", {}, w, 2 * field_.touchLineY());
    if (field_.hasBoundary()) boundary();
    for (const double side : {-1.0, 1.0}) {
      const std::string end = side < 0 ? "own" : "opponent";
      const double goalLine = side * (field_.goalLineX() - w / 2);
      const double length = field_.penaltyAreaLength, width = field_.penaltyAreaWidth;
      line(end + "_goal", {goalLine, 0, 0, 0}, w, field_.goalWidth);
      line(end + "_penalty", {side * (field_.goalLineX() - length + w / 2), 0, 0, 0}, w, width);
      for (const double y : {-1.0, 1.0}) {
        line(end + (y < 0 ? "_penalty_right" : "_penalty_left"),
             {side * (field_.goalLineX() - length / 2), y * (width - w) / 2, 0, 0}, length, w);
      }
    }
    circle();
  }

  /// The lines around a field without walls.
  void boundary() {
    const double w = field_.lineWidth, x = field_.goalLineX() - w / 2, y = field_.touchLineY() - w / 2;
    for (const double side : {-1.0, 1.0}) {
      line(side < 0 ? "own_end" : "opponent_end", {side * x, 0, 0, 0}, w, 2 * y + w);
      line(side < 0 ? "touch_right" : "touch_left", {0, side * y, 0, 0}, 2 * x + w, w);
    }
  }

  void circle() {
    const double radius = field_.centerCircleDiameter / 2;
    const double chord = 2 * (radius + field_.lineWidth / 2) * std::tan(kPi / kCirclePieces);
    for (int i = 0; i < kCirclePieces; ++i) {
      const double angle = 2 * kPi * i / kCirclePieces;
      line(fmt::format("circle{}", i), {radius * std::cos(angle), radius * std::sin(angle), 0, angle},
           field_.lineWidth, chord);
    }
  }

  void wall(const std::string& name, double x, double y, double length, double width) {
    solid("wall_" + name, {x, y, field_.wallHeight / 2, 0}, box(length, width, field_.wallHeight),
          field_.wallColor);
  }

  void walls() {
    const double t = field_.wallThickness;
    if (t <= 0) return;
    for (const double side : {-1.0, 1.0}) {
      const std::string name = side < 0 ? "right" : "left";
      wall(name, 0, side * (field_.width + t) / 2, field_.length + 2 * t, t);
      // The end walls leave a gap for the goal.
      const double gap = field_.goalWidth + 2 * kGoalPanel, piece = (field_.width - gap) / 2;
      for (const double end : {-1.0, 1.0}) {
        wall((end < 0 ? "own_" : "opponent_") + name, end * (field_.length + t) / 2, side * (gap + piece) / 2,
             t, piece);
      }
    }
  }

  /// Writes each corner triangle as two boxes along its long side; the deeper one fills the corner that the
  /// first one leaves.
  void corners() {
    if (field_.cornerTriangleSide <= 0) return;
    const double height = field_.cornerTriangleSide / std::sqrt(2);  // over the long side
    const double depths[] = {0, height * 0.6, height * 0.95};
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        for (int i = 0; i < 2; ++i) {
          const double from = depths[i], depth = depths[i + 1] - from;
          const double out = (field_.cornerTriangleSide / 2 + (from + depth / 2) / std::sqrt(2));
          const std::string name =
              fmt::format("corner_{}_{}{}", x < 0 ? "own" : "opponent", y < 0 ? "right" : "left", i);
          solid(name,
                {x * (field_.length / 2 - field_.cornerTriangleSide + out),
                 y * (field_.width / 2 - field_.cornerTriangleSide + out), field_.wallHeight / 2,
                 x * y * kPi / 4},
                box(depth, 2 * (height - from), field_.wallHeight), field_.wallColor);
        }
      }
    }
  }

  void goalPanels(const FieldDescription::Goal& goal) {
    const double out = goal.x < 0 ? -1 : 1, h = field_.goalHeight;
    const std::string name = "goal_" + goal.name;
    const double backX = goal.x + out * (field_.goalDepth + kGoalPanel / 2);
    solid(name + "_back", {backX, 0, h / 2, 0}, box(kGoalPanel, field_.goalWidth + 2 * kGoalPanel, h),
          goal.color);
    for (const double side : {-1.0, 1.0}) {
      solid(name + (side < 0 ? "_right" : "_left"),
            {goal.x + out * field_.goalDepth / 2, side * (field_.goalWidth + kGoalPanel) / 2, h / 2, 0},
            box(field_.goalDepth, kGoalPanel, h), goal.color);
    }
    picture(name + "_floor",
            {goal.x + out * (field_.wallThickness + field_.goalDepth) / 2, 0, -kFloorDepth / 2, 0},
            box(field_.goalDepth - field_.wallThickness, field_.goalWidth, kFloorDepth), field_.surfaceColor,
            false);
  }

  void beaconBands(const FieldDescription::Beacon& beacon) {
    const std::string name = "beacon_" + beacon.name;
    const double x = beacon.position.x(), y = beacon.position.y();
    const double base = field_.beaconBaseHeight, band = field_.beaconBandHeight, radius = field_.beaconRadius;
    const double height = base + 2 * band;
    shape("collision", name, {x, y, height / 2, 0}, cylinder(radius, height), "");
    picture(name + "_base", {x, y, base / 2, 0}, cylinder(radius, base), field_.beaconBaseColor);
    picture(name + "_bottom", {x, y, field_.beaconBottomBandHeight(), 0}, cylinder(radius, band),
            beacon.bottomColor);
    picture(name + "_top", {x, y, field_.beaconTopBandHeight(), 0}, cylinder(radius, band), beacon.topColor);
  }

  const FieldDescription& field_;
  const std::string& name_;
  std::string text_;
};

}  // namespace

std::string fieldModelSdf(const FieldDescription& field, const std::string& name) {
  return ModelWriter(field, name).write();
}

}  // namespace app
