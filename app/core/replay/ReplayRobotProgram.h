// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/replay/ReplayRobot.h"

namespace app {

/// What of a ReplayRobot is made anew with each program; for its sources alone.
struct ReplayRobot::Program {
  Program(const robotlink::Clock& clock, std::vector<logplayer::LogPlatform::Package> packages,
          robotlink::LockstepExecutor::Options options)
      : platform(clock, std::move(packages)), executor(std::move(options)) {}
  ~Program() { executor.clear(); }

  logplayer::LogPlatform platform;
  std::unique_ptr<robotlink::RobotProgram> program;
  robotlink::LockstepExecutor executor;
};

}  // namespace app
