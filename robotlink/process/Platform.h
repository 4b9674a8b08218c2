// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/process/Process.h"

namespace robotlink {

/// Where a robot program's sensor readings come from and its actuator commands go to. For the program it is
/// an ordinary process; beyond that it owns the clock that all of the program's processes go by, and STOP
/// acts on it.
class Platform : public Process {
 public:
  using Process::Process;

  /// Gives the actuators what the receivers hold; called before the world moves. execute(), called after,
  /// sends the sensors.
  virtual void actuate() = 0;
  /// While engaged, the robot is held safe by the platform, whatever the program asks for. Any thread.
  virtual void engageStop(bool engaged) = 0;
  /// Senders of packages that no task may need: a debug process receives those that no task does while their
  /// keys are on. What takes time to make is made only while its sender is connected.
  virtual std::vector<AnySender*> onRequest() { return {}; }
};

}  // namespace robotlink
