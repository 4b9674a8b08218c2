// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/process/Process.h"

namespace robotlink {

/// The source of a robot program's sensor data and the receiver of its actuator commands: a simulated robot,
/// a real one or a log. For the program it is an ordinary process; beyond that it owns the clock of all of
/// the program's processes, and STOP acts on it.
class Platform : public Process {
 public:
  using Process::Process;

  /// Applies the received commands to the actuators; called before the world advances. execute(), called
  /// after it, sends the sensor data.
  virtual void actuate() = 0;
  /// While engaged, the platform holds the robot in a safe state, whatever the program requests. Any thread.
  virtual void engageStop(bool engaged) = 0;
  /// Senders of packages that no task needs to receive; the debug process receives them while their debug
  /// keys are on. Packages that are costly to produce are produced only while their sender is connected.
  virtual std::vector<AnySender*> onRequest() { return {}; }
};

}  // namespace robotlink
