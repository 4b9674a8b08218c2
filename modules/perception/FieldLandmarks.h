// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "colortool/image/ColorClasses.h"
#include "colortool/table/PaletteTable.h"
#include "robotlink/config/FieldDescription.h"

namespace modules {

/// An object on the field that is used for localization. A plain value.
struct FieldLandmark {
  enum class Kind { kBeacon, kGoal };
  Kind kind = Kind::kBeacon;
  /// The name in the field's description.
  std::string name;
  /// In the field, m: the axis of a beacon, or the center of a goal's floor.
  robotlink::Vector2 position = robotlink::Vector2::Zero();
  /// Color classes of a beacon's bands; for a goal both are its color.
  int topClass = 0;
  int bottomClass = 0;
};

/// The color classes that the robot program distinguishes, in the order of their numbers.
colortool::ColorClasses fieldClasses(const robotlink::FieldDescription& field);
/// The initial color table, computed from the field's own colors.
colortool::ColorTable fieldColorTable(const robotlink::FieldDescription& field,
                                      const colortool::ColorClasses& classes,
                                      const colortool::LightingRange& lighting);
/// Beacons first, then goals; landmarks with a color that is not a class are dropped.
std::vector<FieldLandmark> fieldLandmarks(const robotlink::FieldDescription& field,
                                          const colortool::ColorClasses& classes);

}  // namespace modules
