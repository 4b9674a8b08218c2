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
#include "widgets/models/RobotBeliefs.h"

class QPainter;
class QPalette;

namespace widgets {

/// What moves on a field: robots and ball where they are (filled) and where the robots believe that they are
/// (dashed outlines with the deviation around them). A plain value, in the field's frame.
struct FieldFigures {
  std::vector<RobotBelief> robots;
  std::optional<robotlink::Vector2> ball;
  double ballRadius = 0.042;  ///< m
  QColor ballColor = QColor(255, 105, 0);
  /// Where models were, oldest first, by name. Empty: no trails.
  std::map<std::string, std::deque<robotlink::Vector2>> trails;
  std::string highlighted;  ///< the model under the cursor
  bool onMap = false;       ///< the ground is a map in the palette's colours, not the field's green
};

/// A place that a model is wanted at.
struct WantedPlace {
  std::string model;
  robotlink::Pose2 pose;
  bool isBall = false;
  bool refused = false;
};

// Pure painters.
void paintFigures(QPainter& painter, const FieldFigures& figures, const QTransform& fieldToWidget,
                  const QPalette& palette);
void paintWanted(QPainter& painter, const WantedPlace& place, const FieldFigures& figures,
                 const QTransform& fieldToWidget, const QPalette& palette);
/// The key to the two ways of drawing, in the lower left corner of `widget`.
void paintLegend(QPainter& painter, const QSizeF& widget, const QPalette& palette);

/// The robot whose figure is at a place: the true one, or the estimated one where only that is known. Empty:
/// none.
std::string robotAt(const FieldFigures& figures, const robotlink::Vector2& place, double tolerance);

/// The name of the model whose figure (the true one) is at a place: robots before the ball. Empty: none.
std::string figureAt(const FieldFigures& figures, const robotlink::Vector2& place, double tolerance);

}  // namespace widgets
