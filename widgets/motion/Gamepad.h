// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

#include "widgets/motion/MotionCommander.h"

namespace widgets {

/// The first gamepad that is plugged in, read with SDL2. The left stick walks, the right stick turns, button
/// A kicks, button B is STOP. Gamepads may be plugged in and removed at any time. No window is opened, and
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
    /// Deflection of the sticks, each axis -1 to 1, after a dead zone of 15 %.
    WalkAxes axes;
    /// Whether button A is pressed now. The caller detects the edge.
    bool kick = false;
    /// Whether button B is pressed now.
    bool stop = false;
  };

  Gamepad();
  ~Gamepad();
  Gamepad(const Gamepad&) = delete;
  Gamepad& operator=(const Gamepad&) = delete;

  /// Opens a gamepad if none is open, and reads it. Does not block.
  State poll();

 private:
  /// SDL's handle, kept out of this header.
  struct Device;
  std::unique_ptr<Device> device_;
};

}  // namespace widgets
