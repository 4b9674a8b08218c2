// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "colortool/ColorClasses.h"
#include "colortool/PaletteTable.h"
#include "robotlink/config/FieldDescription.h"

namespace modules {

/// A thing on the field that tells where one is. A plain value.
struct FieldLandmark {
  enum class Kind { kBeacon, kGoal };
  Kind kind = Kind::kBeacon;
  std::string name;  ///< as in the field's description
  robotlink::Vector2 position =
      robotlink::Vector2::Zero();  ///< m, in the field: a beacon's axis, the middle of a goal's floor
  /// Classes of a beacon's bands; of a goal both are its colour.
  int topClass = 0;
  int bottomClass = 0;
};

/// The colours of the field that the robot program tells apart, in the order of their class numbers.
colortool::ColorClasses fieldClasses(const robotlink::FieldDescription& field);
/// The start-up colour table, made from the field's own colours.
colortool::ColorTable fieldColorTable(const robotlink::FieldDescription& field,
                                      const colortool::ColorClasses& classes,
                                      const colortool::LightingRange& lighting);
/// Beacons first, then goals; those with a colour that is not among the classes are left out.
std::vector<FieldLandmark> fieldLandmarks(const robotlink::FieldDescription& field,
                                          const colortool::ColorClasses& classes);

}  // namespace modules
