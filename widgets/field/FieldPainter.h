// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSizeF>
#include <QTransform>

class QPainter;
class QPalette;
namespace robotlink {
struct FieldDescription;
}

namespace widgets {

// Pure functions that paint a field from above, from its description only. The painter's coordinates are
// those of `fieldToWidget`'s target.

/// Length and width, in metres, of all that belongs to a field, with a little margin.
QSizeF fieldExtent(const robotlink::FieldDescription& field);
void paintField(QPainter& painter, const robotlink::FieldDescription& field, const QTransform& fieldToWidget);
/// Where no field is known: lines each half metre and the axes.
void paintGroundGrid(QPainter& painter, const QSizeF& widget, const QTransform& fieldToWidget,
                     const QPalette& palette);

}  // namespace widgets
