// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/LandmarkLocalizer.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Pose2;
using robotlink::Vector2;

LandmarkLocalizer::LandmarkLocalizer(const Options& options, const Pose2& start, double startDeviation)
    : options_(options),
      random_(options.seed),
      particles_(static_cast<std::size_t>(std::max(1, options.particles))) {
  for (Particle& particle : particles_) {
    particle.pose = {start.x + startDeviation * random_.normal(), start.y + startDeviation * random_.normal(),
                     normalizedAngle(start.heading + startDeviation * random_.normal())};
    keepOnField(particle.pose);
  }
  summarize();
}

void LandmarkLocalizer::keepOnField(Pose2& pose) const {
  pose.x = std::clamp(pose.x, -0.5 * options_.fieldLength, 0.5 * options_.fieldLength);
  pose.y = std::clamp(pose.y, -0.5 * options_.fieldWidth, 0.5 * options_.fieldWidth);
}

void LandmarkLocalizer::move(const Pose2& step, bool shaken) {
  const double drift = (shaken ? 10 : 1) * options_.driftNoise;
  const double way = options_.walkNoise * std::sqrt(std::hypot(step.x, step.y)) + drift;
  const double turn = options_.turnNoise * std::sqrt(std::abs(step.heading)) + drift;
  for (Particle& particle : particles_) {
    const Pose2 noisy{step.x + way * random_.normal(), step.y + way * random_.normal(),
                      step.heading + turn * random_.normal()};
    particle.pose = particle.pose * noisy;
    keepOnField(particle.pose);
  }
}

void LandmarkLocalizer::weigh(std::span<const LandmarkMeasurement> seen) {
  double sum = 0;
  for (Particle& particle : particles_) {
    double squares = 0;
    for (const LandmarkMeasurement& landmark : seen) {
      const Vector2 expected = particle.pose.inverse() * landmark.position;
      const double doubt = (landmark.isGoal ? 2.0 : 1.0) * (2 - landmark.confidence);
      const double bearing = normalizedAngle(landmark.bearing - std::atan2(expected.y(), expected.x())) /
                             (doubt * options_.bearingDeviation);
      const double distance = (landmark.distance - expected.norm()) /
                              (doubt * (options_.distanceDeviation * landmark.distance + 0.1));
      // Bounded, so that one wrong landmark does not outweigh the others.
      squares += std::min(9.0, bearing * bearing) + std::min(9.0, distance * distance);
    }
    sum += std::exp(-0.5 * squares);
    particle.weight *= std::exp(-0.5 * options_.evidence * squares);
  }
  const double mean = sum / static_cast<double>(particles_.size());
  const double usual = std::exp(-1.0 * static_cast<double>(seen.size()));
  fit_ += 0.1 * (std::min(1.0, mean / usual) - fit_);
}

Pose2 LandmarkLocalizer::drawFrom(const LandmarkMeasurement& seen) {
  const double around = random_.uniform(-robotlink::kPi, robotlink::kPi);
  const double distance = std::max(0.1, seen.distance * (1 + options_.distanceDeviation * random_.normal()));
  Pose2 pose{seen.position.x() + distance * std::cos(around), seen.position.y() + distance * std::sin(around),
             0};
  keepOnField(pose);
  const Vector2 direction = seen.position - pose.translation();
  pose.heading = normalizedAngle(std::atan2(direction.y(), direction.x()) - seen.bearing +
                                 options_.bearingDeviation * random_.normal());
  return pose;
}

void LandmarkLocalizer::resample(std::span<const LandmarkMeasurement> seen) {
  const std::size_t count = particles_.size();
  double sum = 0;
  for (const Particle& particle : particles_) sum += particle.weight;
  if (sum <= 0) return;
  const double fresh = fit_ < 0.5 ? options_.newShare * (1 - 2 * fit_) : 0;
  if (fresh == 0 && effectiveParticles(particles_) > 0.5 * static_cast<double>(count)) return;
  drawn_.clear();
  double position = random_.uniform(), passed = 0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = (position + static_cast<double>(i)) / static_cast<double>(count) * sum;
    while (at + 1 < count && passed + particles_[at].weight < wanted) passed += particles_[at++].weight;
    // If duplicates stayed equal, the cloud would shrink whatever is seen.
    const double rough = options_.roughening;
    drawn_.push_back({particles_[at].pose *
                          Pose2{rough * random_.normal(), rough * random_.normal(), rough * random_.normal()},
                      1});
    if (fresh > 0 && random_.uniform() < fresh)
      drawn_.back().pose =
          drawFrom(seen[static_cast<std::size_t>(random_.uniform() * static_cast<double>(seen.size()))]);
  }
  particles_.swap(drawn_);
}

void LandmarkLocalizer::summarize() {
  double sum = 0, x = 0, y = 0, c = 0, s = 0;
  for (const Particle& particle : particles_) {
    sum += particle.weight;
    x += particle.weight * particle.pose.x;
    y += particle.weight * particle.pose.y;
    c += particle.weight * std::cos(particle.pose.heading);
    s += particle.weight * std::sin(particle.pose.heading);
  }
  if (sum <= 0) return;
  x /= sum;
  y /= sum;
  double squares = 0;
  for (const Particle& particle : particles_)
    squares += particle.weight * (std::pow(particle.pose.x - x, 2) + std::pow(particle.pose.y - y, 2));
  estimate_.robotInField = {x, y, std::atan2(s, c)};
  estimate_.positionDeviation = std::sqrt(0.5 * squares / sum);
  // The deviation of a wrapped normal distribution (Mardia 1972).
  const double length = std::clamp(std::hypot(c, s) / sum, 1e-6, 1.0);
  estimate_.headingDeviation = std::sqrt(-2 * std::log(length));
}

void LandmarkLocalizer::update(const Pose2& robotInOdometry, bool shaken,
                               std::span<const LandmarkMeasurement> seen) {
  if (hasOdometry_) move(odometry_.inverse() * robotInOdometry, shaken);
  odometry_ = robotInOdometry;
  hasOdometry_ = true;
  if (!seen.empty()) {
    weigh(seen);
    resample(seen);
  }
  summarize();
}

}  // namespace modules
