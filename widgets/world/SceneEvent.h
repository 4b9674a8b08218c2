// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>

#include "robotlink/base/Geometry.h"

namespace widgets {

/// A key, or a button of the mouse, that is meant for controllers of the scene. A plain value.
struct SceneEvent {
  enum class Kind : std::uint8_t { kKeyPressed, kKeyReleased, kMousePressed, kMouseMoved, kMouseReleased };
  Kind kind = Kind::kKeyPressed;
  /// The name of the key: "A", "1", "Space", "Left".
  QString key = {};
  /// For the mouse: the ray through the cursor, in the field's frame, m.
  robotlink::Vector3 origin = robotlink::Vector3::Zero(), direction = robotlink::Vector3::UnitX();
};

}  // namespace widgets
