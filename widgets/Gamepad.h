// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

#include "widgets/models/MotionCommander.h"

namespace widgets {

/// The first gamepad that is plugged in, by SDL2: left stick walks, right stick turns, A kicks, B is STOP.
/// Asked in each tick of a view; pads may come and go at any time. Opens no window and takes no signals.
/// Without SDL's joysticks there is never a pad. GUI thread.
class Gamepad {
 public:
  struct State {
    bool connected = false;
    QString name;
    WalkAxes axes;      ///< dead zone of 15 % taken out
    bool kick = false;  ///< pressed now
    bool stop = false;
  };

  Gamepad();
  ~Gamepad();
  Gamepad(const Gamepad&) = delete;
  Gamepad& operator=(const Gamepad&) = delete;

  State poll();

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

}  // namespace widgets
