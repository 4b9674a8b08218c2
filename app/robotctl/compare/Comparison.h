// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/robotctl/compare/Bootstrap.h"

namespace app {

/// The unit of shares.
inline constexpr char kShare[] = "share";

/// A figure of one run: "models/pose position mean", with its unit ("m", "rad", "s", kShare, or none).
struct Figure {
  std::string name, unit;
  double value = 0;
};

/// The figures that a run has printed (`robotctl sim --errors --json`, `robotctl run --errors --json`):
/// errors, goals, contacts with the ball, and what it cost. Errors of several robots are pooled by how many
/// samples each has: means and shares as if all samples were of one robot, medians and percentiles as means
/// that are weighted so.
std::vector<Figure> figuresIn(const nlohmann::json& printed);

/// The difference of two variants in a figure, on the subjects that both were tried on.
struct Difference {
  std::string figure, unit, first, second;
  std::size_t subjects = 0;
  MeanInterval change;  ///< that of the second minus that of the first
  /// The chance that there is no difference, corrected for the number of differences; see chanceOf().
  double chance = 1;
  /// Whether the bounds exclude that there is no difference, and that is not by chance.
  bool isReal() const { return (change.low > 0 || change.high < 0) && chance <= kMaxChance; }
  static constexpr double kMaxChance = 0.05;
};

/// The figures of several variants, each tried on some subjects. A plain value.
class Comparison {
 public:
  struct Cell {
    std::map<std::string, double> bySubject = {};
    /// The cached result of meanOf().
    mutable std::optional<MeanInterval> mean = {};
  };
  struct Row {
    std::string name, unit;
    std::map<std::string, Cell> byVariant;

    /// The value of all runs of all variants, if they have the same.
    std::optional<double> constant() const;
  };

  void add(const std::string& variant, const std::string& subject, const std::vector<Figure>& figures);
  /// The variants in the order in which they were added.
  const std::vector<std::string>& variants() const { return variants_; }
  const std::vector<Row>& rows() const { return rows_; }
  /// Mean and bounds of a variant in a row; computed once. One thread at a time.
  static MeanInterval meanOf(const Row& row, const std::string& variant);
  /// Each pair of variants in each row whose values are not all the same, in order.
  std::vector<Difference> differences() const;

 private:
  std::vector<std::string> variants_;
  std::vector<Row> rows_;
};

}  // namespace app
