// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {
class StreamStore;
}

namespace widgets {

/// Where a robot on wheels is going and how, as models/path tells it; metres and radians, in the field's
/// frame.
struct DriveAim {
  std::string robot;
  QColor color;  ///< the robot's
  robotlink::Pose2 goal;
  bool anyHeading = true;
  QString name;  ///< of the goal; may be empty
  std::vector<robotlink::Vector2> path;
  bool blocked = false;
  QString reason;  ///< why there is no way
};

/// Nothing if it is going nowhere.
std::optional<DriveAim> driveAim(const robotlink::StreamStore& store, const std::string& robot,
                                 robotlink::Instant shown);

}  // namespace widgets
