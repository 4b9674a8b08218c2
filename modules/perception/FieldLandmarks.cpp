// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/FieldLandmarks.h"

#include <array>
#include <cmath>

namespace modules {
namespace {

constexpr std::array<std::string_view, 10> kClassNames = {"orange", "pink", "yellow", "skyblue", "green",
                                                          "white",  "red",  "blue",   "black",   "robotBlue"};

std::vector<colortool::NamedColor> namedColors(const robotlink::FieldDescription& field) {
  std::vector<colortool::NamedColor> colors;
  for (const auto& color : field.palette) colors.push_back({color.name, color.rgb});
  return colors;
}

}  // namespace

colortool::ColorClasses fieldClasses(const robotlink::FieldDescription& field) {
  return colortool::ColorClasses::select(namedColors(field), kClassNames);
}

colortool::ColorTable fieldColorTable(const robotlink::FieldDescription& field,
                                      const colortool::ColorClasses& classes,
                                      const colortool::LightingRange& lighting) {
  return colortool::paletteTable(namedColors(field), classes, lighting);
}

std::vector<FieldLandmark> fieldLandmarks(const robotlink::FieldDescription& field,
                                          const colortool::ColorClasses& classes) {
  std::vector<FieldLandmark> landmarks;
  for (const auto& beacon : field.beacons)
    landmarks.push_back({FieldLandmark::Kind::kBeacon, beacon.name, beacon.position,
                         classes.index(beacon.topColor), classes.index(beacon.bottomColor)});
  for (const auto& goal : field.goals) {
    const int color = classes.index(goal.color);
    const double middle = goal.x + std::copysign(0.5 * field.goalDepth, goal.x);
    landmarks.push_back({FieldLandmark::Kind::kGoal, goal.name, {middle, 0}, color, color});
  }
  std::erase_if(landmarks, [](const FieldLandmark& l) { return l.topClass == 0 || l.bottomClass == 0; });
  return landmarks;
}

}  // namespace modules
