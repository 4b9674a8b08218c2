// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "widgets/motion/MotionCommander.h"

namespace widgets {

/// The positions of a gamepad's sticks, triggers and buttons at one instant, in the order of kAxes and
/// kButtons.
struct GamepadReading {
  /// SDL's names of the axes; triggers range from 0 to 1, the others from -1 to 1, where y points down.
  static constexpr std::array<const char*, 6> kAxes{"leftx",  "lefty",       "rightx",
                                                    "righty", "lefttrigger", "righttrigger"};
  static constexpr std::array<const char*, 21> kButtons{"a",
                                                        "b",
                                                        "x",
                                                        "y",
                                                        "back",
                                                        "guide",
                                                        "start",
                                                        "leftstick",
                                                        "rightstick",
                                                        "leftshoulder",
                                                        "rightshoulder",
                                                        "dpup",
                                                        "dpdown",
                                                        "dpleft",
                                                        "dpright",
                                                        "misc1",
                                                        "paddle1",
                                                        "paddle2",
                                                        "paddle3",
                                                        "paddle4",
                                                        "touchpad"};

  std::array<double, kAxes.size()> axes{};
  std::array<bool, kButtons.size()> buttons{};
};

/// The functions of the axes and buttons of gamepads. A plain value; as shipped, the left stick walks, the
/// right one turns, A kicks and B is STOP.
struct GamepadBindings {
  /// The function of an axis.
  struct Axis {
    enum class Use : std::uint8_t { kNothing, kForward, kLeft, kTurn };
    Use use = Use::kNothing;
    /// The share of the deflection that does nothing, 0 to kMaxDeadZone; beyond it begins at 0.
    double deadZone = 0.15;
    /// The value of full deflection, -kMaxScale to kMaxScale; negative: reversed.
    double scale = 1;
    bool operator==(const Axis&) const = default;
  };
  static constexpr double kMaxDeadZone = 0.9, kMaxScale = 1;

  /// In the order of GamepadReading::kAxes.
  std::array<Axis, GamepadReading::kAxes.size()> axes{{{Axis::Use::kLeft, 0.15, -1},
                                                       {Axis::Use::kForward, 0.15, -1},
                                                       {Axis::Use::kTurn, 0.15, -1},
                                                       {},
                                                       {},
                                                       {}}};
  /// Lines of commands by the names of buttons; an empty line does nothing. Buttons that are missing do what
  /// they do as shipped.
  std::map<std::string, std::string> buttons;
  bool operator==(const GamepadBindings&) const = default;
};

/// The deflection for walking; several axes for one direction add up, to 1 at most.
WalkAxes walkAxes(const GamepadReading& reading, const GamepadBindings& bindings);

/// The commands of the buttons that are pressed, by the buttons' names.
std::map<std::string, std::string> pressedCommands(const GamepadReading& reading,
                                                   const GamepadBindings& bindings);
/// Whether a button is pressed that does what it does as shipped.
bool isPressedAsShipped(const GamepadReading& reading, const GamepadBindings& bindings, const char* button);

}  // namespace widgets
