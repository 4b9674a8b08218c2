// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/LeftOverPrograms.h"

#include <algorithm>

#include "app/core/program/RobotHost.h"

namespace app {

void LeftOverPrograms::end(std::unique_ptr<ProgramExecutor> executor, const std::vector<RobotHost*>& robots) {
  if (!executor || executor->stop()) return;
  LeftOver left;
  for (RobotHost* robot : robots) {
    const bool runs = robot->platform() != nullptr && !executor->hasEnded(*robot->platform());
    if (runs) left.programs.push_back(robot->release());
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
