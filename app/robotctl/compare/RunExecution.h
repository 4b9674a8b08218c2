// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/robotctl/compare/Comparison.h"
#include "app/robotctl/compare/RunPlan.h"
#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

/// Executes the runs of a comparison or a tournament: the options about it, and the execution. A
/// plain value.
struct RunExecution {
  /// The simulated length of each run.
  double seconds = 60;
  std::uint64_t firstSeed = 1;
  /// The folder of results and report.
  std::string out = {};
  /// "slurm", or empty: here.
  std::string batch = {};
  /// 0: as many as there are cores.
  unsigned parallel = 0;
  int retries = 1;
  /// The name of what the runs are a part of, for the progress line; empty: nothing.
  std::string partOf = {};

  /// Options of `robotctl sim` for each run.
  std::vector<std::string> options = {};

  /// The results of the runs, in their order.
  struct Results {
    /// The output of each run.
    std::vector<std::pair<PlannedRun, nlohmann::json>> results;
    /// "variant, subject" of the runs without a result.
    std::vector<std::string> missing;
  };

  /// Adds the options to a command; this object must outlive it.
  void addTo(CLI::App& command);
  /// Adds what is given behind "--".
  void addOptionsTo(CLI::App& command);
  /// Executes those that have no result yet, here or in a batch system, and those that fail again; shows on a
  /// terminal how far it is, and which are missing. A signal ends it. Fails if the folder cannot be written,
  /// the batch system refuses, or a result cannot be read.
  robotlink::Result<Results> execute(std::vector<PlannedRun> runs) const;
  /// Executes the first of the simulations of each variant for no time, so that common errors of all of
  /// them are reported at once. Fails with the texts of those that fail.
  robotlink::Result<Results> tryOut(const std::vector<PlannedRun>& runs) const;

 private:
  robotlink::Result<std::vector<PlannedRun>> executeAll(const RunFiles& files, std::vector<PlannedRun> runs,
                                                        std::size_t before) const;
};

/// Fails unless all of these are solutions of the task; the error says what there is.
robotlink::Result<void> checkSolutions(const std::string& task, const std::vector<std::string>& solutions);
/// Prints the differences that are real, a line each.
void printDifferences(const Comparison& comparison);

}  // namespace app
