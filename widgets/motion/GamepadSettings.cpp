// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/GamepadSettings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "robotlink/session/VersionedFile.h"

namespace widgets {
namespace {

using PadAxis = GamepadBindings::Axis;
/// The functions of axes, in the order of GamepadBindings::Axis::Use.
constexpr std::array<const char*, 4> kGamepadUses{"nothing", "forward", "left", "turn"};

const robotlink::VersionedFormat& gamepadFormat() {
  static const robotlink::VersionedFormat instance{"robotcontrol-gamepad", 1, "gamepad"};
  return instance;
}

double numberIn(const nlohmann::json& from, const char* name, double usual, double low, double high) {
  const auto found = from.find(name);
  if (found == from.end() || !found->is_number()) return usual;
  const auto value = found->get<double>();
  return std::isfinite(value) ? std::clamp(value, low, high) : usual;
}

PadAxis axisFrom(const nlohmann::json& from, const PadAxis& usual) {
  if (!from.is_object()) return usual;
  PadAxis axis = usual;
  const auto use = from.find("does");
  for (std::size_t i = 0; use != from.end() && i < kGamepadUses.size(); ++i) {
    if (*use == kGamepadUses[i]) axis.use = static_cast<PadAxis::Use>(i);
  }
  axis.deadZone = numberIn(from, "dead_zone", usual.deadZone, 0, GamepadBindings::kMaxDeadZone);
  axis.scale = numberIn(from, "scale", usual.scale, -GamepadBindings::kMaxScale, GamepadBindings::kMaxScale);
  return axis;
}

}  // namespace

GamepadSettings::GamepadSettings(std::filesystem::path file) : file_(std::move(file)) {
  if (!file_.empty()) load();
}

void GamepadSettings::load() {
  const auto contents = robotlink::readVersioned(file_, gamepadFormat());
  if (!contents) {
    problem_ = robotlink::keepAside(file_, contents.error());
    return;
  }
  const auto axes = contents->find("axes"), buttons = contents->find("buttons");
  for (std::size_t i = 0; axes != contents->end() && axes->is_object() && i < bindings_.axes.size(); ++i) {
    const auto found = axes->find(GamepadReading::kAxes[i]);
    if (found != axes->end()) bindings_.axes[i] = axisFrom(*found, bindings_.axes[i]);
  }
  if (buttons == contents->end() || !buttons->is_object()) return;
  for (const char* button : GamepadReading::kButtons) {
    const auto found = buttons->find(button);
    if (found != buttons->end() && found->is_string()) bindings_.buttons[button] = found->get<std::string>();
  }
}

robotlink::Result<void> GamepadSettings::set(GamepadBindings bindings) {
  bindings_ = std::move(bindings);
  if (file_.empty()) return {};
  const GamepadBindings shipped;
  nlohmann::json contents = nlohmann::json::object();
  for (std::size_t i = 0; i < bindings_.axes.size(); ++i) {
    const PadAxis& axis = bindings_.axes[i];
    if (axis == shipped.axes[i]) continue;
    contents["axes"][GamepadReading::kAxes[i]] = {{"does", kGamepadUses[static_cast<std::size_t>(axis.use)]},
                                                  {"dead_zone", axis.deadZone},
                                                  {"scale", axis.scale}};
  }
  for (const auto& [button, command] : bindings_.buttons) contents["buttons"][button] = command;
  return robotlink::writeVersioned(file_, gamepadFormat(), contents);
}

}  // namespace widgets
