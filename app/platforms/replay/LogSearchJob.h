// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"

namespace app {

class Workbench;

/// Searches whole logs for where an expression is true, in a thread of its own, without playing them. What a
/// log lacks is computed by its robots' programs, apart from those of a replay. One search at a time; the
/// destructor ends it. All functions in the thread of the owner.
class LogSearchJob {
 public:
  struct Plan {
    std::vector<std::filesystem::path> logs;
    std::string expression;
    /// The CSV file that gets what is found: log, robot, from and until in seconds from the log's start,
    /// text. Empty: none.
    std::filesystem::path file = {};
  };

  LogSearchJob();
  /// Fails if a search runs.
  robotlink::Result<void> begin(Plan plan);
  /// Whether it runs. Fails, once, with why it failed; to find nothing is a failure.
  robotlink::Result<bool> working();

 private:
  bool isRunning_ = false;
  robotlink::Worker<Plan, robotlink::Result<void>> worker_;
};

/// Attaches log.search, which searches the logs that are open in the workbench, and makes scripts wait for
/// it.
void addLogSearch(Workbench& workbench);

}  // namespace app
