// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "widgets/scene/SceneMesh.h"

namespace widgets {

/// Lines each half metre, each second one stronger, fainter with the distance from the middle, just below the
/// ground.
SceneLines gridLines(const QColor& color);

}  // namespace widgets
