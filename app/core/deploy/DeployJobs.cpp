// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/DeployJobs.h"

namespace app {

DeployJobs::~DeployJobs() {
  isEnding_ = true;
  jobs_.close();
}

void DeployJobs::run(const std::string& robot, std::vector<DeployFile> files, bool sends) {
  {
    const std::lock_guard lock(mutex_);
    states_[robot] = {};
    states_[robot].isBusy = true;
  }
  jobs_.add([this, robot, files = std::move(files), sends] {
    Deployment deployment(call_);
    const Deployment::Progress progress = [&](double share) {
      const std::lock_guard lock(mutex_);
      states_[robot].share = share;
      return !isEnding_;
    };
    auto done = sends ? deployment.send(files, progress) : deployment.check(files, progress);
    const std::lock_guard lock(mutex_);
    State& state = states_[robot] = {};
    state.wasSent = sends;
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
