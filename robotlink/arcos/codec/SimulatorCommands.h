// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/codec/Command.h"

// The commands to simulators whose data have a form of their own.
namespace robotlink::arcos {

/// SIM_SET_POSE: where the robot shall be put; its odometry stays as it is.
struct TruePose {
  std::int32_t xMm = 0;
  std::int32_t yMm = 0;
  std::int32_t headingDeg = 0;
  bool operator==(const TruePose&) const = default;
};
Command setTruePose(const TruePose& pose);
/// Nothing if the command's data are too short; coordinates that are missing at their end are not guessed.
std::optional<TruePose> truePoseOf(const Command& command);

/// SIM_CTRL.
struct SimulatorControl {
  enum Operation {
    kLoadMap = 1,
    kLoadMasterMap = 2,
    kClearMasterMap = 3,
    kRotateLogs = 4,
    kLogState = 5,
    kInfo = 6,
    kGhost = 7,
  };
  int operation = 0;  ///< 0 to 65535, perhaps none of these
  std::string file;   ///< of kLoadMap and kLoadMasterMap, else empty
  bool operator==(const SimulatorControl&) const = default;
};
Command simulatorControl(const SimulatorControl& control);
/// Nothing if there is no operation, or a file's name is shorter than it says.
std::optional<SimulatorControl> simulatorControlOf(const Command& command);

}  // namespace robotlink::arcos
