// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/codec/Command.h"

// Commands to simulators with a data layout of their own, as defined by MobileSim.
namespace robotlink::arcos {

/// SIM_SET_POSE: the pose to move the robot to; its odometry does not change.
struct TruePose {
  std::int32_t xMm = 0;
  std::int32_t yMm = 0;
  std::int32_t headingDeg = 0;
  bool operator==(const TruePose&) const = default;
};
/// Builds the command.
Command setTruePose(const TruePose& pose);
/// Empty if the command's data are too short; missing coordinates are not guessed.
std::optional<TruePose> truePoseOf(const Command& command);

/// SIM_CTRL: operations of the simulator.
struct SimulatorControl {
  /// The operations that are known; most concern maps and log files.
  enum Operation {
    kLoadMap = 1,
    kLoadMasterMap = 2,
    kClearMasterMap = 3,
    kRotateLogs = 4,
    kLogState = 5,
    kInfo = 6,
    kGhost = 7,
  };
  /// In 0 to 65535, not necessarily one of the above.
  int operation = 0;
  /// Only for kLoadMap and kLoadMasterMap.
  std::string file;
  bool operator==(const SimulatorControl&) const = default;
};
/// Builds the command.
Command simulatorControl(const SimulatorControl& control);
/// Empty if the operation is missing or a file name is shorter than its length says.
std::optional<SimulatorControl> simulatorControlOf(const Command& command);

}  // namespace robotlink::arcos
