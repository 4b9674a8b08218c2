// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTransform>
#include <vector>

#include "robotlink/base/Geometry.h"

class QPainter;
namespace foxglove {
class SceneEntity;
}

namespace widgets {

struct WorldDrawing;

/// Paints a drawing of the world as seen from above: everything is projected to the ground, in the order in
/// which it is stored, fills first. `frameInField` is the frame of the entity's coordinates. Widths and font
/// sizes that are scale-invariant in the drawing are screen pixels. `style` is that of lines. Pure.
void paintFromAbove(QPainter& painter, const foxglove::SceneEntity& entity,
                    const robotlink::Pose3& frameInField, const QTransform& fieldToWidget,
                    Qt::PenStyle style = Qt::SolidLine);

/// Paints several drawings from above, the lowest first; old ones are faded, and those of solutions in the
/// shadow dashed.
void paintFromAbove(QPainter& painter, const std::vector<WorldDrawing>& drawings,
                    const QTransform& fieldToWidget);

}  // namespace widgets
