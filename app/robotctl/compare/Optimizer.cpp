// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Optimizer.h"

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace app {
namespace {

constexpr std::array<std::pair<const char*, nlopt_algorithm>, 3> kAlgorithms{
    {{"crs2", NLOPT_GN_CRS2_LM}, {"esch", NLOPT_GN_ESCH}, {"sbplx", NLOPT_LN_SBPLX}}};
/// The first steps of a local search, as shares of the ranges.
constexpr double kFirstStep = 0.1;

struct Search {
  const Optimizer::Cost& cost;
  nlopt_opt_s* search = nullptr;
  bool hasEnded = false;
};

/// The cost of points once the search has ended: some algorithms notice the end only after a while.
constexpr double kNoCost = 1e30;

double costAt(unsigned dimensions, const double* point, double* /*gradient*/, void* data) {
  auto& search = *static_cast<Search*>(data);
  const auto cost = search.hasEnded ? std::nullopt : search.cost({point, point + dimensions});
  search.hasEnded = !cost;
  if (!cost) nlopt_force_stop(search.search);
  return cost.value_or(kNoCost);
}

}  // namespace

const std::vector<std::string>& Optimizer::algorithms() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const auto& [name, algorithm] : kAlgorithms) names.emplace_back(name);
    return names;
  }();
  return kNames;
}

void Optimizer::minimize(const std::vector<double>& start, const Cost& cost) const {
  const auto* known = std::ranges::find(kAlgorithms, algorithm, [](const auto& each) { return each.first; });
  if (known == kAlgorithms.end() || evaluations <= 0 || start.empty()) return;
  nlopt_srand(static_cast<unsigned long>(seed));
  const auto dimensions = static_cast<unsigned>(start.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> made(nlopt_create(known->second, dimensions),
                                                                    &nlopt_destroy);
  if (!made) return;
  Search search{cost, made.get()};
  nlopt_set_min_objective(made.get(), &costAt, &search);
  nlopt_set_lower_bounds1(made.get(), 0);
  nlopt_set_upper_bounds1(made.get(), 1);
  nlopt_set_initial_step1(made.get(), kFirstStep);
  nlopt_set_maxeval(made.get(), evaluations);
  // A third of all is spent on the first population, however many there are.
  const auto usual = 10 * (dimensions + 1);
  if (known->second == NLOPT_GN_CRS2_LM)
    nlopt_set_population(made.get(),
                         std::max(dimensions + 1, std::min(usual, static_cast<unsigned>(evaluations) / 3)));
  std::vector<double> point = start;
  for (double& each : point) each = std::clamp(each, 0.0, 1.0);
  double least = 0;
  nlopt_optimize(made.get(), point.data(), &least);
}

}  // namespace app
