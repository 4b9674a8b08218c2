// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/correction/RadialFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace colortool {
namespace {

constexpr int kIterations = 12;
/// The standard deviation of r^2 within the groups must be at least this; over a whole image it is 0.2.
constexpr double kMinDeviation = 0.12;
constexpr double kMinFreedom = 4;
/// Residuals of more standard deviations than this count less.
constexpr double kHuber = 1.5;
/// The required decrease of the sum of squares, in variances: chance causes it once in a thousand times.
constexpr double kMinRadialGain = 14;
/// The shade of an image's corners stays above this while it is being fitted.
constexpr double kDarkest = 0.15;

struct Limits {
  double noise;    ///< minimum standard deviation of a sample
  double typical;  ///< typical size of coefficients
};
Limits limitsOf(RadialModel model) {
  return model == RadialModel::kShade ? Limits{0.005, 0.5} : Limits{0.3, 15};
}

/// The residual of a sample and its derivatives at some coefficients.
struct Equation {
  std::size_t group;
  double weight;
  double residual;
  Eigen::Vector2d slope;
};

double radialCurve(const Eigen::Vector2d& c, double squaredRadius) {
  return (c[0] + c[1] * squaredRadius) * squaredRadius;
}

/// Subtracts the weighted mean of each group from its equations: the rest is independent of the group's own
/// mean.
void center(std::vector<Equation>& equations) {
  struct Sums {
    double weight = 0, residual = 0;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  };
  std::vector<Sums> groups;
  for (const Equation& e : equations) {
    groups.resize(std::max(groups.size(), e.group + 1));
    groups[e.group].weight += e.weight;
    groups[e.group].residual += e.weight * e.residual;
    groups[e.group].slope += e.weight * e.slope;
  }
  for (Equation& e : equations) {
    const Sums& sums = groups[e.group];
    if (sums.weight <= 0) continue;
    e.residual -= sums.residual / sums.weight;
    e.slope -= sums.slope / sums.weight;
  }
}

std::vector<Equation> equationsAt(const Eigen::Vector2d& c, std::span<const RadialSample> samples,
                                  RadialModel model, std::span<const double> trust) {
  std::vector<Equation> equations;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const RadialSample& s = samples[i];
    const double r2 = s.squaredRadius;
    const double shade = std::max(1 + radialCurve(c, r2), kDarkest);
    const bool tint = model == RadialModel::kTint;
    const double expected = tint ? radialCurve(c, r2) : std::log(shade);
    equations.push_back({s.group, s.weight * trust[i], s.value - expected,
                         Eigen::Vector2d(r2, r2 * r2) / (tint ? 1 : shade)});
  }
  center(equations);
  return equations;
}

double freedomOf(std::span<const RadialSample> samples) {
  double sum = 0;
  std::vector<std::size_t> groups;
  for (const RadialSample& sample : samples) {
    sum += sample.weight;
    groups.push_back(sample.group);
  }
  std::ranges::sort(groups);
  // clang 14 does not compile std::ranges::unique with this standard library.
  const auto different = std::unique(groups.begin(), groups.end()) - groups.begin();
  return sum - static_cast<double>(different);
}

/// Returns the standard deviation of most of the residuals.
double deviationOf(const std::vector<Equation>& equations) {
  std::vector<double> sizes;
  sizes.reserve(equations.size());
  for (const Equation& e : equations) sizes.push_back(std::abs(e.residual));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return 1.4826 * *middle;
}

double squares(const std::vector<Equation>& equations) {
  double sum = 0;
  for (const Equation& e : equations) sum += e.weight * e.residual * e.residual;
  return sum;
}

/// Whether there are enough samples at different distances from the center.
bool isWideEnough(std::span<const RadialSample> samples) {
  const double freedom = freedomOf(samples);
  if (freedom < kMinFreedom) return false;
  const std::vector<double> trust(samples.size(), 1);
  double sum = 0;
  for (const Equation& e : equationsAt(Eigen::Vector2d::Zero(), samples, RadialModel::kTint, trust))
    sum += e.weight * e.slope[0] * e.slope[0];
  return std::sqrt(sum / freedom) >= kMinDeviation;
}

/// Shortens the step, so that no corner becomes darker than possible.
Eigen::Vector2d limitedRadius(const Eigen::Vector2d& c, RadialModel model) {
  const double corner = 1 + c.sum();
  return model == RadialModel::kShade && corner < kDarkest ? c * (1 - kDarkest) / (1 - corner) : c;
}

}  // namespace

RadialFit fitRadial(std::span<const RadialSample> samples, RadialModel model) {
  if (!isWideEnough(samples)) return {};
  const Limits limits = limitsOf(model);
  Eigen::Vector2d c = Eigen::Vector2d::Zero();
  std::vector<double> trust(samples.size(), 1);
  double deviation = limits.noise;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const auto equations = equationsAt(c, samples, model, trust);
    deviation = std::max(deviationOf(equations), limits.noise);
    const double prior = deviation * deviation / (limits.typical * limits.typical);
    Eigen::Matrix2d normal = prior * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = -prior * c;
    for (std::size_t i = 0; i < equations.size(); ++i) {
      const Equation& e = equations[i];
      normal += e.weight * e.slope * e.slope.transpose();
      right += e.weight * e.residual * e.slope;
      const double size = std::abs(e.residual) / (kHuber * deviation);
      trust[i] = size <= 1 ? 1 : 1 / size;
    }
    c = limitedRadius(c + normal.ldlt().solve(right), model);
  }
  const double before = squares(equationsAt(Eigen::Vector2d::Zero(), samples, model, trust));
  const double after = squares(equationsAt(c, samples, model, trust));
  const double variance = std::max(deviation * deviation, after / (freedomOf(samples) - 2));
  if (before - after < kMinRadialGain * variance) return {RadialFit::Outcome::kNothing, {}};
  return {RadialFit::Outcome::kFound, {c[0], c[1]}};
}

}  // namespace colortool
