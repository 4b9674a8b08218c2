// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/core/platform/HeadlessRun.h"
#include "app/core/platform/PlatformForm.h"
#include "app/platforms/real/RealRun.h"

namespace app {

/// An adapter's declaration of how its real robots run without a window. A plain value.
struct RealHeadless {
  // The same as in HeadlessPlatform.
  const char* help;
  const char* usage;
  /// The robot's name if the user gives none.
  std::string robot;
  /// Options in addition to those of all real robots.
  std::vector<PlatformField> options = {};
  /// The robot with its platform, of what the user chose.
  RealRobotOptions (*robotOf)(const std::string& url, const FormValues& values);
};

/// Runs a real robot without a window: its program runs here in real time until the time is over or the
/// user interrupts it. The state of the connection is printed. The run fails if the robot was never
/// connected.
HeadlessPlatform headlessReal(RealHeadless declared);

}  // namespace app
