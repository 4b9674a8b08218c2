// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/process/Process.h"

namespace robotcontrol {
class ControlDrive;
class SetCamera;
}  // namespace robotcontrol

namespace robotlink {

/// The source of a robot program's sensor data and the receiver of its actuator commands: a simulated robot,
/// a real one or a log. For the program it is an ordinary process; beyond that it owns the clock of all of
/// the program's processes, and STOP acts on it.
class Platform : public Process {
 public:
  using Process::Process;

  /// Sets up sensors and motors, before the first frame and when it is known that the program can run.
  virtual void initialize() {}
  /// Leaves the robot safe, after the last frame; also called where initialize() was not.
  virtual void shutDown() {}

  /// Gives the actuators what the receivers hold; called before the world moves. execute(), called after,
  /// sends the sensors.
  virtual void actuate() = 0;
  /// While engaged, the platform holds the robot in a safe state, whatever the program requests. Any thread.
  virtual void engageStop(bool engaged) = 0;
  virtual bool stopEngaged() const { return false; }
  /// To be set while the robot's program cannot give commands, since it has ended or does not answer. Other
  /// than STOP, it ends by itself when the program gives commands again. Any thread.
  void setUnattended(bool unattended) { unattended_.store(unattended); }
  bool unattended() const { return unattended_.load(); }
  /// Fulfills a request of the user for the robot's base. Refused if the robot has no wheels.
  virtual Result<void> control(const robotcontrol::ControlDrive& details);
  /// Changes a setting of the robot's camera. Refused if the robot has no camera, or the camera has no such
  /// setting or not that value.
  virtual Result<void> setCamera(const robotcontrol::SetCamera& details);
  /// Why nothing of what the robot does can be changed by requests, neither by STOP nor for its base, as a
  /// sentence; empty if it can. Settings of its camera are no part of that.
  virtual std::string refusal() const { return {}; }
  /// Senders of packages that no task may need: a debug process receives those that no task does while their
  /// keys are on. What takes time to make is made only while its sender is connected.
  virtual std::vector<AnySender*> onRequest() { return {}; }

  /// Removes and returns sentences for the user about setting up and shutting down since the last call. Any
  /// thread.
  std::vector<std::string> takeReports();
  /// The same about what does not work, such as a device that cannot be opened. Any thread.
  std::vector<std::string> takeProblems();

 protected:
  void report(std::string text);
  void reportProblem(std::string text);
  /// Whether the robot has to stand, whatever was requested last.
  bool mustStand() const { return stopEngaged() || unattended(); }

 private:
  std::atomic<bool> unattended_{false};
  std::mutex reportsMutex_;  // protects reports_ and problems_
  std::vector<std::string> reports_, problems_;
};

}  // namespace robotlink
