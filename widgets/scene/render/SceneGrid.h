// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "widgets/scene/render/SceneMesh.h"

namespace widgets {

/// A grid just below the ground with lines every half meter, every second one stronger; they fade with the
/// distance from the center.
SceneLines gridLines(const QColor& color);

}  // namespace widgets
