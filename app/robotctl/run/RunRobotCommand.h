// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "app/robotctl/run/RecordOptions.h"

namespace app {

/// The arguments of `robotctl run` for a real robot.
struct RunRobotArguments {
  /// Address of the robot, see isRobotAddress().
  std::string url;
  /// A file, or the name of a shipped layout; empty: the default of the robot's kind.
  std::string layout;
  /// Map file (.map) of the building in which the robot drives; empty: none.
  std::string map;
  /// Name of the robot.
  std::string robot = "p3at1";
  /// Solution by task, instead of those of the layout.
  std::map<std::string, std::string> solutions;
  /// Duration; 0: until interrupted.
  double seconds = 0;
  /// Whether the motors are switched on as soon as the robot is connected.
  bool motorsOn = false;
  /// Whether the figures are printed as JSON.
  bool asJson = false;
  /// Whether text messages of the program are printed.
  bool texts = false;
  RecordOptions record;
};

/// Whether a platform's name is the address of a robot: tcp://..., serial://..., or a short form that
/// robotlink::arcos::parseUrl() accepts, such as a device in /dev.
bool isRobotAddress(const std::string& platform);

/// Connects to a robot and runs its program until the time is over or the user presses Ctrl-C; reports the
/// state of the connection on stderr. Returns an ExitStatus: kFailed if the robot was never connected.
int runRobot(const RunRobotArguments& arguments);

}  // namespace app
