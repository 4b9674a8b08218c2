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

/// A drawing that a robot's program published and that is visible at the shown instant.
struct CurrentDrawing {
  /// Name without the robot, as DrawingsModel has it: "image/ball-percept/circle", or
  /// "image/shadow/region/ball-percept/circle" of a solution that runs in the shadow of another.
  QString id;
  std::string robot;
  /// The drawing: foxglove.ImageAnnotations or foxglove.SceneUpdate.
  robotlink::PackagePtr message;
  /// Time of the frame in which it was drawn.
  robotlink::Instant time;
  /// Whether its process has executed a newer frame without drawing it; it is painted faded then.
  bool old = false;

  bool operator==(const CurrentDrawing&) const = default;
};

/// Whether a drawing of this name is of a solution that runs in the shadow of another; its lines are dashed.
bool isDrawnInShadow(const QString& id);

/// Opacity of an old drawing: enough to find it, too little to be taken for a current one.
inline constexpr double kOldDrawingOpacity = 0.3;
/// The same of one that was drawn in shadow mode: it must not be taken for that of the solution in use.
inline constexpr double kShadowDrawingOpacity = 0.6;
/// The opacity with which a drawing is painted.
double drawingOpacity(const QString& id, bool old);

/// Returns the drawings among `ids` that the robot published in the newest frame of the drawing process, in
/// the order of `ids`, and the last drawings of keys that do not draw in every frame (marked as old).
/// Drawings that a process no longer makes are left out.
std::vector<CurrentDrawing> currentDrawings(robotlink::Session& session, const std::string& robot,
                                            const QStringList& ids, robotlink::Instant shown);

}  // namespace widgets
