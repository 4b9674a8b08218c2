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

/// Paths and goals of robots on wheels, and a goal that is being chosen or was just sent. A plain value;
/// meters in the field's frame.
struct GoalFigures {
  std::vector<DriveAim> aims;
  /// Unset: none.
  std::optional<GoalSender::Aim> wanted;
};

/// Pure.
void paintGoals(QPainter& painter, const GoalFigures& goals, const QTransform& fieldToWidget,
                const QPalette& palette);

}  // namespace widgets
