// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// A drawing of a robot that is to be seen at the instant that is shown.
struct CurrentDrawing {
  QString id;  ///< as DrawingsModel names it: "image/ball-percept/circle"
  std::string robot;
  robotlink::PackagePtr message;

  bool operator==(const CurrentDrawing&) const = default;
};

/// Those of `ids` that the robot drew in the newest frame of the process that draws them, in the order of
/// `ids`. What a process no longer draws is gone.
std::vector<CurrentDrawing> currentDrawings(robotlink::Session& session, const std::string& robot,
                                            const QStringList& ids, robotlink::Instant shown);

}  // namespace widgets
