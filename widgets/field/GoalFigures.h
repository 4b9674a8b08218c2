// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTransform>
#include <optional>
#include <vector>

#include "widgets/field/GoalSender.h"
#include "widgets/world/DriveAims.h"

class QPainter;
class QPalette;

namespace widgets {

/// The figures for the paths and goals of robots on wheels, and for a goal that is being chosen or was just
/// sent. A plain value; meters in the field's frame.
struct GoalFigures {
  /// A figure for each robot that has a goal.
  std::vector<DriveAim> aims;
  /// The goal that is being chosen or was just sent; unset if there is none.
  std::optional<GoalSender::Aim> wanted;
};

/// Paints paths and goals. A pure function.
void paintGoals(QPainter& painter, const GoalFigures& goals, const QTransform& fieldToWidget,
                const QPalette& palette);

}  // namespace widgets
