// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/RunEnd.h"

#include <utility>

#include "app/core/program/Abandoned.h"
#include "app/platforms/simulated/SimulatedRun.h"

namespace app {

RunEnd::RunEnd(std::unique_ptr<SimulatedRun> run, std::shared_ptr<void> used)
    : used_(std::move(used)), run_(std::move(run)) {}

RunEnd::~RunEnd() {
  run_->end();
  if (run_->hasEnded()) return;
  using Both = std::pair<std::shared_ptr<void>, std::unique_ptr<SimulatedRun>>;
  auto both = std::make_shared<Both>(std::move(used_), std::move(run_));
  const SimulatedRun* left = both->second.get();
  abandon(std::move(both), [left] { return left->hasEnded(); });
}

}  // namespace app
