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

/// The goal of a robot on wheels and its path to it, as the robot's program publishes them (models/path).
/// Meters and radians in the field's frame.
struct DriveAim {
  std::string robot;
  /// The robot's color, set by the view.
  QColor color;
  robotlink::Pose2 goal;
  /// Whether the robot may arrive with any heading; that of `goal` means nothing then.
  bool anyHeading = true;
  /// Name of the place that is the goal; may be empty.
  QString name;
  /// Corners of the path, from where the robot was when it was planned to the goal.
  std::vector<robotlink::Vector2> path;
  /// Whether no path exists at present.
  bool blocked = false;
  /// The reason why it is blocked.
  QString reason;
};

/// The robot's goal at an instant; unset if it has none or it was canceled.
std::optional<DriveAim> driveAim(const robotlink::StreamStore& store, const std::string& robot,
                                 robotlink::Instant shown);

}  // namespace widgets
