// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/platforms/real/RealRun.h"

namespace app {

/// The name of the PlatformAdapter of Pioneers.
inline constexpr char kPioneerAdapter[] = "pioneer";

/// A Pioneer at the other end of a line, by an address of PioneerAddress.h: "tcp://localhost:8101" or
/// "serial:///dev/ttyUSB0?baud=9600". Its name is that of its kind: p3at1. An invalid address is refused
/// when its platform is made. `motorsOn`: whether the motors are switched on when the robot is connected.
RealRobotOptions pioneerOptions(std::string url, bool motorsOn = false);

}  // namespace app
