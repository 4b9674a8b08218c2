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
  robotlink::Instant time;  ///< of the frame that drew it
  bool old = false;         ///< its process has had a newer frame, in which it was not drawn: shown faded

  bool operator==(const CurrentDrawing&) const = default;
};

/// How much of an old drawing is seen: enough to find it, too little to take it for what is seen now.
inline constexpr double kOldDrawingOpacity = 0.3;

/// Those of `ids` that the robot drew in the newest frame of the process that draws them, in the order of
/// `ids`; and the last ones of keys that are not on in each frame, which are old then. What a process no
/// longer draws is gone.
std::vector<CurrentDrawing> currentDrawings(robotlink::Session& session, const std::string& robot,
                                            const QStringList& ids, robotlink::Instant shown);

}  // namespace widgets
