// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSizeF>
#include <QTransform>

class QPainter;
class QPalette;
namespace robotlink {
struct FieldDescription;
}

// Pure functions that paint a field from above by its description. The painter's coordinates are those to
// which `fieldToWidget` maps.
namespace widgets {

/// Length and width in m of everything that belongs to a field, with a small margin.
QSizeF fieldExtent(const robotlink::FieldDescription& field);
/// Paints carpet, lines, goals and landmarks.
void paintField(QPainter& painter, const robotlink::FieldDescription& field, const QTransform& fieldToWidget);
/// Paints lines every half meter and the axes, where no field is known.
void paintGroundGrid(QPainter& painter, const QSizeF& widget, const QTransform& fieldToWidget,
                     const QPalette& palette);

}  // namespace widgets
