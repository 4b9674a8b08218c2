// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/replay/ReplayRobot.h"

namespace app {

/// The parts of a ReplayRobot that are made together for each program. For the sources of ReplayRobot only.
struct ReplayRobot::Program {
  Program(const robotlink::Clock& clock, std::vector<logplayer::LogPlatform::Package> packages,
          robotlink::LockstepExecutor::Options options)
      : platform(clock, std::move(packages)), executor(std::move(options)) {}
  /// The executor must release the processes before these are destroyed.
  ~Program() { executor.clear(); }

  logplayer::LogPlatform platform;
  std::unique_ptr<robotlink::RobotProgram> program;
  /// Declared after platform and program, which it uses.
  robotlink::LockstepExecutor executor;
};

}  // namespace app
