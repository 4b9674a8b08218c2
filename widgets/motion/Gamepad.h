// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>
#include <memory>
#include <string>

#include "widgets/motion/GamepadBindings.h"
#include "widgets/motion/MotionCommander.h"

namespace widgets {

/// The first gamepad that is plugged in, read with SDL2. What its axes and buttons do is bound by
/// GamepadBindings. Gamepads may be plugged in and removed at any time. No window is opened, and
/// SDL installs no signal handlers. Without SDL's game controller subsystem no gamepad is ever found. GUI
/// thread; poll() is called once in each tick of a view.
class Gamepad {
 public:
  /// The state of sticks and buttons at one instant.
  struct State {
    /// Whether a gamepad is plugged in; if not, all other members have their defaults.
    bool connected = false;
    /// The device's name as SDL reports it.
    QString name;
    /// Deflection for walking, each axis -1 to 1, after the dead zones.
    WalkAxes axes;
    /// Whether button A is pressed now, and does what it does as shipped. The caller detects the edge.
    bool kick = false;
    /// The same for button B.
    bool stop = false;
    /// The commands of the buttons that are pressed now, by the buttons' names.
    std::map<std::string, std::string> commands = {};
  };

  Gamepad();
  ~Gamepad();
  Gamepad(const Gamepad&) = delete;
  Gamepad& operator=(const Gamepad&) = delete;

  /// Opens a gamepad if none is open, and reads it. Does not block.
  State poll(const GamepadBindings& bindings = {});

 private:
  /// SDL's handle, kept out of this header.
  struct Device;
  std::unique_ptr<Device> device_;
};

}  // namespace widgets
