// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// A search for the least cost of a point in the unit cube by an algorithm of the library NLopt (S. G.
/// Johnson: The NLopt nonlinear-optimization package, https://github.com/stevengj/nlopt). A plain value.
struct Optimizer {
  /// "crs2": controlled random search with local mutation (P. Kaelo, M. M. Ali: Some variants of the
  /// controlled random search algorithm for global optimization, 2006). "esch": an evolutionary algorithm (C.
  /// H. da Silva Santos et al., 2010). "sbplx": Nelder-Mead on a sequence of subspaces (T. Rowan: Functional
  /// stability analysis of numerical algorithms, 1990), which looks around the start only.
  std::string algorithm;
  /// The maximum number of computations of the cost.
  int evaluations = 0;
  /// The same seed tries the same points, as long as the costs are the same.
  std::uint64_t seed = 1;

  static const std::vector<std::string>& algorithms();

  /// Costs have to be finite; none ends the search.
  using Cost = std::function<std::optional<double>(const std::vector<double>& point)>;
  /// Searches from a start, which is evaluated, too. The caller keeps what was best. One thread at a time in
  /// a program, as NLopt has one source of random numbers.
  void minimize(const std::vector<double>& start, const Cost& cost) const;
};

}  // namespace app
