// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/core/deploy/Deployment.h"
#include "app/core/recordings/JobQueue.h"

namespace app {

/// Deployments to the robots of one server, in a thread that waits for it. One thread uses it; what `call`
/// uses must outlive it.
class DeployJobs {
 public:
  /// What came of the newest job of a robot, and how the one in progress is getting on. A plain value.
  struct State {
    bool isBusy = false;
    double share = 0;
    /// Whether files were sent, rather than compared only.
    bool wasSent = false;
    /// Nothing before the first job is done, and if it failed.
    std::optional<std::vector<DeployDifference>> differences = {};
    std::optional<robotlink::Error> error = {};
  };

  explicit DeployJobs(ServiceCall call) : call_(std::move(call)) {}
  /// Cancels what is in progress; takes some tenths of a second then.
  ~DeployJobs();
  DeployJobs(const DeployJobs&) = delete;
  DeployJobs& operator=(const DeployJobs&) = delete;

  void check(const std::string& robot, std::vector<DeployFile> files) { run(robot, std::move(files), false); }
  void send(const std::string& robot, std::vector<DeployFile> files) { run(robot, std::move(files), true); }
  /// Empty if nothing was asked for.
  State state(const std::string& robot) const;

 private:
  void run(const std::string& robot, std::vector<DeployFile> files, bool sends);

  const ServiceCall call_;
  std::atomic<bool> isEnding_ = false;
  /// Protects the states.
  mutable std::mutex mutex_;
  std::map<std::string, State> states_;
  /// The last member, since its thread uses the others.
  JobQueue jobs_;
};

}  // namespace app
