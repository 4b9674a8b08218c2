// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "robotlink/arcos/server/MotionController.h"

/// Wheels that follow commands at once and do not slip.
struct IdealWheels {
  static constexpr robotlink::Duration kStep = std::chrono::milliseconds(4);

  robotlink::arcos::MotionController::Wheels wheels;
  robotlink::arcos::WheelCommand command;

  void obey(const robotlink::arcos::WheelCommand& commanded) {
    command = commanded;
    if (!commanded.motorsOn) return;
    wheels.leftTravel += commanded.left * robotlink::seconds(kStep);
    wheels.rightTravel += commanded.right * robotlink::seconds(kStep);
  }
};
