// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/DeployJobs.h"

namespace app {

DeployJobs::~DeployJobs() {
  ++cancels_;
  jobs_.close();
}

void DeployJobs::cancel() {
  ++cancels_;
  jobs_.clear();
  const std::lock_guard lock(mutex_);
  for (auto& [robot, state] : states_) {
    if (!state.isBusy) continue;
    state = {};
    state.error = robotlink::Error{"canceled", "canceled", {}, {}};
  }
}

void DeployJobs::run(const std::string& robot, std::vector<DeployFile> files, Job job) {
  {
    const std::lock_guard lock(mutex_);
    states_[robot] = {};
    states_[robot].isBusy = true;
  }
  jobs_.add([this, robot, files = std::move(files), job, cancels = cancels_.load()] {
    Deployment deployment(call_, robot);
    const Deployment::Progress progress = [&](double share) {
      const std::lock_guard lock(mutex_);
      if (cancels != cancels_) return false;
      states_[robot].share = share;
      return true;
    };
    auto done = job == Job::kSend      ? deployment.send(files, progress)
                : job == Job::kRestart ? deployment.restart(files, progress)
                                       : deployment.check(files, progress);
    const std::lock_guard lock(mutex_);
    if (cancels != cancels_) return;
    State& state = states_[robot] = {};
    state.wasSent = job == Job::kSend;
    state.wasRestarted = job == Job::kRestart;
    if (done)
      state.differences = *std::move(done);
    else
      state.error = done.error();
  });
}

DeployJobs::State DeployJobs::state(const std::string& robot) const {
  const std::lock_guard lock(mutex_);
  const auto found = states_.find(robot);
  return found == states_.end() ? State() : found->second;
}

}  // namespace app
