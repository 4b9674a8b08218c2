// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// A keyboard or mouse event of a user in a view of the world. A plain value.
struct ViewEvent {
  enum class Kind : std::uint8_t { kKeyPressed, kKeyReleased, kMousePressed, kMouseMoved, kMouseReleased };
  Kind kind = Kind::kKeyPressed;
  /// The view in which it happened: "scene".
  std::string view = {};
  /// For keys: what is on it, such as "A", "1", "Space", "Left".
  std::string key = {};
  /// For the mouse: 1 left, 2 middle, 3 right. Moves are reported while it is pressed.
  int button = 0;
  /// For the mouse: the ray from the eye through the cursor, in the world, m. The direction is of length 1.
  robotlink::Vector3 origin = robotlink::Vector3::Zero(), direction = robotlink::Vector3::UnitX();
  /// The first hit of the ray at the step in which the event enters: a visual as "MODEL/LINK/VISUAL", and its
  /// model. Empty if it hits nothing. The simulation fills these in.
  std::string object = {}, model = {};
  /// The point that the ray hits, in the world, m.
  robotlink::Vector3 point = robotlink::Vector3::Zero();

  bool isOfMouse() const { return kind >= Kind::kMousePressed; }
};

}  // namespace simcore
