// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QTransform>
#include <vector>

#include "widgets/drawings/DrawingTip.h"
#include "widgets/world/WorldDrawings.h"

namespace widgets {

/// The drawings that paintFromAbove() paints at a place of a widget, the topmost first, with the texts,
/// places (in the field's frame, m) and metadata of their parts.
std::vector<DrawingHit> drawingsAt(const std::vector<WorldDrawing>& drawings, const QTransform& fieldToWidget,
                                   const QPointF& at);

/// The tooltip about any part of an entity: its name, if that is not its drawing's name, and its
/// metadata.
QStringList entityValues(const foxglove::SceneEntity& entity, const QString& drawing);
/// "(1.000, 0.500, 0.042) m".
QString worldPlaceText(const robotlink::Vector3& place);

}  // namespace widgets
