// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <QTransform>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "widgets/world/RobotBeliefs.h"

class QPainter;
class QPalette;

namespace widgets {

/// The suffix of a robot's name for trails of its estimates.
inline constexpr char kEstimateTrail[] = "/estimate", kBallTrail[] = "/ball";

/// Objects on a field: robots and ball at their true poses (filled) and at the robots' estimates (dashed
/// outlines with their standard deviations). A plain value; meters in the field's frame.
struct FieldFigures {
  std::vector<RobotBelief> robots;
  /// The true position of the ball; unset: unknown.
  std::optional<robotlink::Vector2> ball;
  /// m
  double ballRadius = 0.042;
  QColor ballColor = QColor(255, 105, 0);
  /// Former positions by model, oldest first; empty: no trails. Those of "red1/estimate" and "red1/ball" (see
  /// below) are where the robot believed itself and the ball to be.
  std::map<std::string, std::deque<robotlink::Vector2>> trails;
  /// The model under the cursor; empty: none.
  std::string highlighted;
  /// Whether lines lead from where robots and ball are to where they are believed, with the distance.
  bool errorLines = false;
  /// Whether the ground is a map in the palette's colors instead of the green field.
  bool onMap = false;
};

/// A pose to which a model is being dragged.
struct WantedPlace {
  std::string model;
  robotlink::Pose2 pose;
  bool isBall = false;
  /// Whether the simulation has refused it.
  bool refused = false;
};

/// Paints the figures. Pure, like the following painters.
void paintFigures(QPainter& painter, const FieldFigures& figures, const QTransform& fieldToWidget,
                  const QPalette& palette);
/// Paints the model at the wanted pose.
void paintWanted(QPainter& painter, const WantedPlace& place, const FieldFigures& figures,
                 const QTransform& fieldToWidget, const QPalette& palette);
/// Explains filled and dashed figures in the lower left corner; `widget` is its size.
void paintLegend(QPainter& painter, const QSizeF& widget, const QPalette& palette);

/// The robot whose figure is within `tolerance` (m) of a place: the true one, or the estimated one if the
/// true pose is unknown. Empty: none.
std::string robotAt(const FieldFigures& figures, const robotlink::Vector2& place, double tolerance);

/// The model whose true figure is within `tolerance` (m) of a place, robots before the ball. Empty: none.
std::string figureAt(const FieldFigures& figures, const robotlink::Vector2& place, double tolerance);

}  // namespace widgets
