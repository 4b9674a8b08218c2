// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/FieldMarks.h"

#include <QCoreApplication>

#include "robotlink/config/FieldDescription.h"

namespace widgets {
namespace {

/// Appends the points of one kind in all quarters of the field; those on an axis only once.
void addQuarters(std::vector<FieldMark>& marks, const QString& kind, double x, double y) {
  for (const double signX : {-1.0, 1.0}) {
    if (x == 0 && signX > 0) continue;
    for (const double signY : {1.0, -1.0}) {
      if (y == 0 && signY < 0) continue;
      marks.push_back({kind, {signX * x, signY * y, 0}});
    }
  }
}

}  // namespace

QString FieldMark::placeText() const {
  // A negative zero would be shown with its sign.
  return QStringLiteral("%1, %2").arg(place.x() + 0.0, 0, 'f', 2).arg(place.y() + 0.0, 0, 'f', 2);
}

QString FieldMark::name() const {
  return QStringLiteral("%1 (%2)").arg(kind, placeText());
}

std::vector<FieldMark> fieldMarks(const robotlink::FieldDescription& field) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("FieldMarks", text); };
  std::vector<FieldMark> marks;
  const double goalLine = field.goalLineX(), touchLine = field.touchLineY();
  addQuarters(marks,
              field.hasBoundary() ? translated(QT_TRANSLATE_NOOP("FieldMarks", "field corner"))
                                  : translated(QT_TRANSLATE_NOOP("FieldMarks", "wall corner")),
              goalLine, touchLine);
  addQuarters(marks, translated(QT_TRANSLATE_NOOP("FieldMarks", "halfway line")), 0, touchLine);
  if (field.centerCircleDiameter > 0)
    addQuarters(marks, translated(QT_TRANSLATE_NOOP("FieldMarks", "center circle")), 0,
                field.centerCircleDiameter / 2);
  if (field.penaltyAreaLength > 0) {
    addQuarters(marks, translated(QT_TRANSLATE_NOOP("FieldMarks", "penalty corner")),
                goalLine - field.penaltyAreaLength, field.penaltyAreaWidth / 2);
    addQuarters(marks, translated(QT_TRANSLATE_NOOP("FieldMarks", "penalty at goal")), goalLine,
                field.penaltyAreaWidth / 2);
  }
  for (const auto& goal : field.goals)
    for (const double side : {1.0, -1.0})
      marks.push_back({translated(QT_TRANSLATE_NOOP("FieldMarks", "goal post")),
                       {goal.x, side * field.goalWidth / 2, 0}});
  for (const auto& beacon : field.beacons)
    marks.push_back({translated(QT_TRANSLATE_NOOP("FieldMarks", "beacon")),
                     {beacon.position.x(), beacon.position.y(), 0}});
  return marks;
}

}  // namespace widgets
