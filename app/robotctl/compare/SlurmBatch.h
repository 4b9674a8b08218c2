// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/robotctl/compare/RunPlan.h"
#include "app/robotctl/compare/RunPool.h"

namespace app {

/// Hands runs to the batch system Slurm as an array of jobs, one for each run, and waits for their results.
/// The folder of the runs has to be the same on all of its machines, as has this program. Jobs end with the
/// results that they have if this object's execute() is ended. One thread.
class SlurmBatch {
 public:
  explicit SlurmBatch(const RunFiles& files) : files_(files) {}

  /// The script of the array: job N executes line N (from 1) of the file of commands.
  std::string script(std::size_t runs) const;
  /// The lines of that file.
  std::string commands(const std::vector<PlannedRun>& runs, const std::string& program) const;

  /// Submits all of these, and returns those that failed or were not executed. Fails if Slurm refuses the
  /// array; the reason is what its command printed.
  robotlink::Result<std::vector<PlannedRun>> execute(const std::vector<PlannedRun>& runs,
                                                     const std::function<bool(const RunProgress&)>& look);

 private:
  const RunFiles& files_;
};

}  // namespace app
