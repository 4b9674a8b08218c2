// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/robotctl/compare/CompareReport.h"
#include "app/robotctl/compare/Comparison.h"
#include "app/robotctl/compare/Optimizer.h"
#include "app/robotctl/compare/ParameterSpace.h"
#include "app/robotctl/compare/RunExecution.h"
#include "robotlink/base/Error.h"

namespace app {

/// The objective of tuning: simulations with some seeds, of which the mean of one
/// figure counts. Each candidate is a preset in the folder of results, and its runs are kept as those of
/// comparisons, so that the same tuning continues where it ended.
struct TuningTask {
  std::string scene;
  /// The name of a figure, see Figure::name.
  std::string figure;
  bool maximize = false;
  int seeds = 3, heldOut = 10;
  /// The task and the solution that is tuned, which each run uses: "motion=wheel-model-fast".
  std::string solution = {};
  /// The stages, run one after the other, each from the best point so far.
  std::vector<Optimizer> stages = {};
  RunExecution execution = {};
};

/// A candidate and its result.
struct TunedPoint {
  std::vector<double> point;
  /// The figure's mean; none: a run had no result.
  std::optional<double> value;
  std::string stage;
};

/// A search for the best parameters. One thread.
class Tuning {
 public:
  /// Both must outlive it.
  Tuning(const TuningTask& task, const ParameterSpace& space) : task_(task), space_(space) {}

  /// Runs all stages; returns true if they were completed, false if a signal ended them. Fails if results
  /// cannot be kept or have no such figure.
  robotlink::Result<bool> search();
  /// All candidates in the order in which they were first tried; the first one is today's.
  const std::vector<TunedPoint>& tried() const { return tried_; }
  const TunedPoint& best() const { return tried_[best_]; }

  /// Runs today's parameters ("today") and the best ones ("tuned") with seeds that the search has not seen.
  robotlink::Result<Comparison> validate();
  /// "variant, subject" of the runs of validate() that have no result.
  const std::vector<std::string>& missing() const { return missing_; }

  /// The course of the search: a row for each candidate.
  std::string courseCsv() const;
  /// Today's and the best numbers, and how each stage ended.
  std::vector<ReportTable> tables() const;

 private:
  /// The runs of a candidate.
  robotlink::Result<std::vector<PlannedRun>> runsOf(const std::string& variant,
                                                    const std::vector<double>& point, std::uint64_t firstSeed,
                                                    int seeds) const;
  /// Fails if the first candidates all have the same figure: the parameters do not matter for it.
  robotlink::Result<void> checkThatParametersMatter() const;
  /// Tries a point; nothing if the search is to end.
  std::optional<double> costAt(const std::vector<double>& point, const std::string& stage);
  robotlink::Result<std::optional<double>> evaluate(const std::vector<double>& point);
  bool isBetter(double value, double than) const { return task_.maximize ? value > than : value < than; }

  const TuningTask& task_;
  const ParameterSpace& space_;
  std::vector<TunedPoint> tried_;
  std::size_t best_ = 0;
  /// Indices in `tried_` by the numbers that a run gets.
  std::map<std::vector<std::string>, std::size_t> known_;
  std::optional<robotlink::Error> error_;
  std::vector<std::string> missing_;
};

}  // namespace app
