// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QPointF>
#include <optional>

namespace widgets {

/// How far, in pixels, a picture moves when an arrow key is pressed; nothing for other keys. It moves against
/// the arrow, so that more is seen of the picture in its direction.
inline std::optional<QPointF> panOfKey(const QKeyEvent& event, double step) {
  switch (event.key()) {
    case Qt::Key_Left:
      return QPointF(step, 0);
    case Qt::Key_Right:
      return QPointF(-step, 0);
    case Qt::Key_Up:
      return QPointF(0, step);
    case Qt::Key_Down:
      return QPointF(0, -step);
    default:
      return std::nullopt;
  }
}

}  // namespace widgets
