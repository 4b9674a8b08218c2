// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>
#include <vector>

#include "widgets/drawings/DrawingTip.h"
#include "widgets/scene/render/SceneFrame.h"

namespace widgets {

/// The drawings at a place of a widget in which the camera shows them, the topmost first, with their texts
/// and the places (in the field's frame, m) that are seen there. What hides them does not matter; drawings
/// without an id are left out.
std::vector<DrawingHit> drawingsAt(const std::vector<SceneBody>& drawings, const SceneCamera& camera,
                                   const QSizeF& widget, const QPointF& at);

}  // namespace widgets
