// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/GamepadBindings.h"

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

double deflectionOf(double raw, const GamepadBindings::Axis& axis) {
  const double value = std::clamp(raw, -1.0, 1.0);
  const double beyond = std::max(0.0, std::abs(value) - axis.deadZone) / (1 - axis.deadZone);
  return std::copysign(beyond, value) * axis.scale;
}

}  // namespace

WalkAxes walkAxes(const GamepadReading& reading, const GamepadBindings& bindings) {
  using Use = GamepadBindings::Axis::Use;
  WalkAxes axes;
  for (std::size_t i = 0; i < reading.axes.size(); ++i) {
    const GamepadBindings::Axis& axis = bindings.axes[i];
    double* to = axis.use == Use::kForward ? &axes.forward
                 : axis.use == Use::kLeft  ? &axes.left
                 : axis.use == Use::kTurn  ? &axes.turn
                                           : nullptr;
    if (to != nullptr) *to = std::clamp(*to + deflectionOf(reading.axes[i], axis), -1.0, 1.0);
  }
  return axes;
}

std::map<std::string, std::string> pressedCommands(const GamepadReading& reading,
                                                   const GamepadBindings& bindings) {
  std::map<std::string, std::string> commands;
  for (std::size_t i = 0; i < reading.buttons.size(); ++i) {
    const auto bound = bindings.buttons.find(GamepadReading::kButtons[i]);
    if (reading.buttons[i] && bound != bindings.buttons.end() && !bound->second.empty())
      commands.insert(*bound);
  }
  return commands;
}

bool isPressedAsShipped(const GamepadReading& reading, const GamepadBindings& bindings, const char* button) {
  if (bindings.buttons.contains(button)) return false;
  const std::string name = button;
  for (std::size_t i = 0; i < reading.buttons.size(); ++i) {
    if (GamepadReading::kButtons[i] == name) return reading.buttons[i];
  }
  return false;
}

}  // namespace widgets
