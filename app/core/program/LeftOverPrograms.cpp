// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/LeftOverPrograms.h"

#include <algorithm>

#include "app/core/program/RobotHost.h"
#include "robotlink/process/Platform.h"

namespace app {

struct LeftOverPrograms::LeftOver {
  std::vector<std::unique_ptr<robotlink::Platform>> platforms;
  std::vector<std::unique_ptr<HostedProgram>> programs;
  /// Declared after the programs that it executes.
  std::unique_ptr<ProgramExecutor> executor;
};

LeftOverPrograms::LeftOverPrograms() = default;
LeftOverPrograms::~LeftOverPrograms() = default;

void LeftOverPrograms::end(std::unique_ptr<ProgramExecutor> executor, const std::vector<RobotHost*>& robots,
                           Platforms platforms) {
  if (!executor || executor->stop()) return;
  LeftOver left;
  for (RobotHost* robot : robots) {
    const bool runs = robot->platform() != nullptr && !executor->hasEnded(*robot->platform());
    if (!runs) continue;
    left.programs.push_back(robot->release());
    if (platforms == Platforms::kReplaced) left.platforms.push_back(robot->releasePlatform());
  }
  left.executor = std::move(executor);
  all_.push_back(std::move(left));
}

void LeftOverPrograms::forgetEnded() {
  std::erase_if(all_, [](const LeftOver& left) { return left.executor->hasEnded(); });
}

bool LeftOverPrograms::haveEnded() const {
  return std::ranges::all_of(all_, [](const LeftOver& left) { return left.executor->hasEnded(); });
}

}  // namespace app
