// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/MonteCarloLocalizer.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Pose2;

namespace {

// The number of random poses from which the best are taken to replace particles.
constexpr int kCandidates = 1500;
// Below this fraction of a good fit, the robot may have been carried away.
constexpr double kLostFit = 0.6;
// The additional deviation of an estimate that explains nothing, m.
constexpr double kMisfitDeviation = 2;

}  // namespace

MonteCarloLocalizer::MonteCarloLocalizer(const robotlink::GroundMap& map, const Options& options)
    : options_(options),
      random_(options.seed),
      distances_(map, {}),
      freeSpace_(distances_, map, options.clearance),
      ranges_(distances_, options.ranges) {
  startAnywhere();
}

void MonteCarloLocalizer::setOptions(const Options& options) {
  options_ = options;
  ranges_.setOptions(options.ranges);
}

void MonteCarloLocalizer::startAnywhere() {
  particles_.clear();
  first_ = true;
  fit_ = 0;
  badFits_ = 0;
  if (!freeSpace_.empty()) {
    const double wanted = options_.particlesPerArea * freeSpace_.area();
    const double fewest = std::max(1, options_.fewest);
    const auto count = static_cast<int>(std::clamp(wanted, fewest, std::max<double>(fewest, options_.most)));
    for (int i = 0; i < count; ++i) particles_.push_back(Particle::at(freeSpace_.draw(random_)));
  }
  publish();
}

void MonteCarloLocalizer::startAt(const Pose2& robotInMap, double positionDeviation,
                                  double headingDeviation) {
  particles_.clear();
  first_ = true;
  fit_ = options_.goodFit;
  badFits_ = 0;
  for (int i = 0; i < std::max(1, options_.fewest); ++i) {
    particles_.push_back(
        Particle::at({robotInMap.x + positionDeviation * random_.normal(),
                      robotInMap.y + positionDeviation * random_.normal(),
                      normalizedAngle(robotInMap.heading + headingDeviation * random_.normal())}));
  }
  publish();
}

void MonteCarloLocalizer::move(const Pose2& step) {
  const double way = std::hypot(step.x, step.y), turn = std::abs(step.heading);
  if (way == 0 && turn == 0) return;
  way_ += way;
  turn_ += turn;
  // With the square root, the errors of steps add up to the same, however many steps there are.
  const double wayError = options_.wayNoise * std::sqrt(way) + options_.skidNoise * std::sqrt(turn);
  const double turnError = options_.turnNoise * std::sqrt(turn) + options_.driftNoise * std::sqrt(way);
  for (Particle& particle : particles_) {
    const Pose2 noisy{step.x + wayError * random_.normal(), step.y + 0.5 * wayError * random_.normal(),
                      step.heading + turnError * random_.normal()};
    const float weight = particle.logWeight;
    particle = Particle::at(particle.pose() * noisy);
    particle.logWeight = weight;
  }
}

bool MonteCarloLocalizer::see(std::span<const RangeBeam> beams) {
  const bool moved = first_ || way_ >= options_.leastWay || turn_ >= options_.leastTurn;
  if (moved) ranges_.choose(beams);
  if (!moved || particles_.empty() || ranges_.empty()) {
    publish();
    return false;
  }
  way_ = turn_ = 0;
  weigh();
  publish();
  judge();
  first_ = false;
  if (badFits_ > options_.lostAfter)
    startAnywhere();
  else
    resample();
  return true;
}

void MonteCarloLocalizer::weigh() {
  // Replaced particles are not exact, either.
  const double least = first_ || fit_ < options_.goodFit ? 0.5 * options_.startDeviation : 0;
  ranges_.setRayDeviation(std::clamp(std::max(least, 0.25 * estimate_.positionDeviation),
                                     options_.rayDeviation, options_.startDeviation));
  for (Particle& particle : particles_) {
    particle.logWeight += static_cast<float>(ranges_.logLikelihood(particle));
    // No robot is inside a wall, whatever it would see there.
    if (distances_.at({particle.x, particle.y}) < 0.5 * options_.clearance) particle.logWeight -= 2;
  }
}

void MonteCarloLocalizer::publish() {
  estimate_ = summarize(particles_);
  if (particles_.empty() || first_) return;
  const double misfit = 1 - std::min(1.0, fit_ / options_.goodFit);
  estimate_.positionDeviation = std::max(estimate_.positionDeviation, misfit * kMisfitDeviation);
}

void MonteCarloLocalizer::judge() {
  const Particle& best = *std::ranges::max_element(particles_, {}, &Particle::logWeight);
  const double explained =
      std::max(ranges_.explainedShare(estimate_.robotInField), ranges_.explainedShare(best.pose()));
  fit_ += (first_ ? 1 : 0.15) * (explained - fit_);
  badFits_ = fit_ < kLostFit * options_.goodFit ? badFits_ + 1 : 0;
}

void MonteCarloLocalizer::resample() {
  const bool fits = fit_ >= options_.goodFit;
  if (fits && weightSums(particles_).effective() > 0.5 * static_cast<double>(particles_.size())) return;
  // Only a sample shows how many particles are needed.
  draw(particles_.size());
  const double fewest = std::max(1, options_.fewest);
  const auto needed = static_cast<std::size_t>(
      std::clamp(neededParticles(drawn_), fewest, std::max<double>(fewest, options_.most)));
  if (needed != particles_.size()) draw(needed);
  particles_.swap(drawn_);
  if (!fits) drawAnew();
}

/// Systematic resampling by weight.
void MonteCarloLocalizer::draw(std::size_t count) {
  const WeightSums sums = weightSums(particles_);
  const auto weight = [&](std::size_t i) { return std::exp(particles_[i].logWeight - sums.best); };
  drawn_.clear();
  const double start = random_.uniform();
  double passed = 0, next = weight(0);
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = (start + static_cast<double>(i)) / static_cast<double>(count) * sums.sum;
    while (at + 1 < particles_.size() && passed + next < wanted) {
      passed += next;
      next = weight(++at);
    }
    drawn_.push_back(particles_[at]);
    drawn_.back().logWeight = 0;
  }
}

void MonteCarloLocalizer::drawAnew() {
  const double misfit = 1 - std::min(1.0, fit_ / options_.goodFit);
  const auto count = static_cast<std::size_t>(
      std::min(options_.newShare * misfit * static_cast<double>(particles_.size()), 0.1 * kCandidates));
  if (count == 0 || freeSpace_.empty()) return;
  ranges_.setRayDeviation(options_.startDeviation);
  drawn_.clear();
  for (int i = 0; i < kCandidates; ++i) {
    drawn_.push_back(Particle::at(freeSpace_.draw(random_)));
    drawn_.back().logWeight = static_cast<float>(ranges_.logLikelihood(drawn_.back()));
  }
  std::ranges::nth_element(drawn_, drawn_.begin() + static_cast<std::ptrdiff_t>(count),
                           std::ranges::greater{}, &Particle::logWeight);
  // The new particles replace evenly spaced ones, so that no cluster loses more than its share.
  const std::size_t stride = particles_.size() / count;
  for (std::size_t i = 0; i < count; ++i) {
    particles_[i * stride] = drawn_[i];
    particles_[i * stride].logWeight = 0;
  }
}

}  // namespace modules
