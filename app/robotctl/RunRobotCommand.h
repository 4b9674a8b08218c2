// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "app/robotctl/RecordOptions.h"

namespace app {

/// What `robotctl run` needs to run a program on a real robot.
struct RunRobotArguments {
  std::string url;
  std::string layout;  ///< a file or the name of a shipped one; empty: that of its kind
  std::string map;
  std::string robot = "p3at1";
  std::map<std::string, std::string> solutions;
  double seconds = 0;  ///< 0: until it is interrupted
  bool motorsOn = false;
  bool asJson = false;
  bool texts = false;
  RecordOptions record;
};

/// Whether a platform's name is the address of a robot: tcp://... or serial://...
bool isRobotAddress(const std::string& platform);

/// Connects it and runs its program until the time is over or Ctrl-C; tells on stderr how the connection
/// does. An ExitStatus: failed if the robot was never connected.
int runRobot(const RunRobotArguments& arguments);

}  // namespace app
