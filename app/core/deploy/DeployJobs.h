// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
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
  /// The outcome of a robot's newest job, and the progress of the one that is running. A plain value.
  struct State {
    bool isBusy = false;
    double share = 0;
    /// Whether files were sent, or its program was started again, rather than compared only.
    bool wasSent = false, wasRestarted = false;
    /// Unset before the first job is done, and if it failed.
    std::optional<std::vector<DeployDifference>> differences = {};
    std::optional<robotlink::Error> error = {};
  };

  explicit DeployJobs(ServiceCall call) : call_(std::move(call)) {}
  /// Cancels what is in progress; takes some tenths of a second then.
  ~DeployJobs();
  DeployJobs(const DeployJobs&) = delete;
  DeployJobs& operator=(const DeployJobs&) = delete;

  void check(const std::string& robot, std::vector<DeployFile> files) {
    run(robot, std::move(files), Job::kCheck);
  }
  void send(const std::string& robot, std::vector<DeployFile> files) {
    run(robot, std::move(files), Job::kSend);
  }
  /// See Deployment::restart().
  void restart(const std::string& robot, std::vector<DeployFile> files) {
    run(robot, std::move(files), Job::kRestart);
  }
  /// Cancels what is in progress and what waits; a file that is being sent is sent as a whole or not at all.
  void cancel();
  /// Empty if there was no request.
  State state(const std::string& robot) const;

 private:
  enum class Job { kCheck, kSend, kRestart };
  void run(const std::string& robot, std::vector<DeployFile> files, Job job);

  const ServiceCall call_;
  /// The number of times that all was canceled: earlier jobs do nothing then.
  std::atomic<std::uint64_t> cancels_ = 0;
  /// Protects the states.
  mutable std::mutex mutex_;
  std::map<std::string, State> states_;
  /// The last member, since its thread uses the others.
  JobQueue jobs_;
};

}  // namespace app
