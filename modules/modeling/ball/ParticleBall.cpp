// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/ball/ParticleBall.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace modules {

using Eigen::Matrix2d;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// Particles farther than this from the estimate do not belong to it, m.
constexpr double kNearBall = 0.4;
/// Velocities are computed from percepts of this many seconds, with this error, m/s.
constexpr double kVelocityTime = 0.24, kVelocityError = 0.25;
/// The likelihood of a percept that is wrong.
constexpr double kWrongPercept = 1e-3;

}  // namespace

void ParticleBall::move(double seconds) {
  const double starts = 1 - std::exp(-options_.startRate * seconds);
  const double stops = 1 - std::exp(-options_.stopRate * seconds);
  const double drift = options_.drift * std::sqrt(seconds);
  for (Particle& particle : particles_) {
    const bool rolls = !particle.velocity.isZero();
    const double chance = random_.uniform();
    if (!rolls && chance < starts)
      particle.velocity = options_.startSpeed * Vector2{random_.normal(), random_.normal()};
    else if (rolls && chance < stops)
      particle.velocity.setZero();
    const double speed = particle.velocity.norm();
    if (speed > 0) particle.velocity *= options_.roll.speedAfter(speed, seconds) / speed;
    if (speed > 0)
      particle.velocity +=
          options_.velocityNoise * std::sqrt(seconds) * Vector2{random_.normal(), random_.normal()};
    particle.position += particle.velocity * seconds + drift * Vector2{random_.normal(), random_.normal()};
  }
}

ParticleBall::Particle ParticleBall::drawAt(const Vector2& place, const Matrix2d& root) {
  Particle particle;
  particle.position = place + root * Vector2{random_.normal(), random_.normal()};
  if (random_.uniform() < 0.5) return particle;
  const double passed = recent_.empty() ? 0 : recent_.back().time - recent_.front().time;
  const bool known = passed > 0.5 * kVelocityTime;
  particle.velocity =
      (known ? kVelocityError : options_.startSpeed) * Vector2{random_.normal(), random_.normal()};
  if (known) particle.velocity += (recent_.back().place - recent_.front().place) / passed;
  return particle;
}

void ParticleBall::see(const BallMeasurement& seen, const Pose2& robotInOdometry) {
  const Vector2 place = robotInOdometry * seen.position;
  const Matrix2d covariance = options_.accuracy.covariance(seen.position, seen.confidence, robotInOdometry);
  const auto count = static_cast<std::size_t>(std::max(1, options_.particles));
  if (particles_.empty()) {
    const Matrix2d root = covariance.llt().matrixL();
    for (std::size_t i = 0; i < count; ++i) particles_.push_back(drawAt(place, root));
    return;
  }
  const Matrix2d inverse = covariance.inverse();
  for (Particle& particle : particles_) {
    const Vector2 off = particle.position - place;
    particle.weight *= kWrongPercept + std::exp(-0.5 * options_.evidence * off.dot(inverse * off));
  }
  resample(place, covariance);
}

void ParticleBall::resample(const Vector2& place, const Matrix2d& covariance) {
  const auto count = static_cast<std::size_t>(std::max(1, options_.particles));
  const Matrix2d root = covariance.llt().matrixL();
  double sum = 0;
  for (const Particle& particle : particles_) sum += particle.weight;
  const double start = random_.uniform();
  double passed = 0;
  std::size_t at = 0;
  drawn_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = (start + static_cast<double>(i)) / static_cast<double>(count) * sum;
    while (at + 1 < particles_.size() && passed + particles_[at].weight < wanted)
      passed += particles_[at++].weight;
    drawn_.push_back(random_.uniform() < options_.newShare ? drawAt(place, root) : particles_[at]);
    drawn_.back().weight = 1;
  }
  particles_.swap(drawn_);
}

void ParticleBall::remember(double time, const Vector2& place) {
  recent_.push_back({time, place});
  while (time - recent_.front().time > kVelocityTime) recent_.pop_front();
}

void ParticleBall::summarize(const Pose2& robotInOdometry) {
  // The center is the median of each coordinate, which a minority elsewhere does not move much.
  std::vector<double> values(particles_.size());
  const auto median = [&](int axis) {
    std::ranges::transform(particles_, values.begin(), [&](const auto& p) { return p.position[axis]; });
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
  };
  const Vector2 middle(median(0), median(1));
  Vector2 position = Vector2::Zero(), velocity = Vector2::Zero();
  double squares = 0, count = 0;
  for (const Particle& particle : particles_) {
    const Vector2 off = particle.position - middle;
    squares += off.squaredNorm();
    if (off.norm() > kNearBall) continue;
    position += particle.position;
    velocity += particle.velocity;
    ++count;
  }
  if (count > 0) {
    position /= count;
    velocity /= count;
  } else {
    position = middle;
  }
  estimate_.position = robotInOdometry.inverse() * position;
  estimate_.velocity = Pose2{0, 0, -robotInOdometry.heading} * velocity;
  estimate_.deviation = std::sqrt(0.5 * squares / static_cast<double>(particles_.size()));
}

void ParticleBall::forget() {
  seenAt_.reset();
  estimate_.known = false;
  particles_.clear();
  recent_.clear();
}

void ParticleBall::update(double time, const Pose2& robotInOdometry,
                          const std::optional<BallMeasurement>& seen) {
  const double seconds = updatedAt_ ? time - *updatedAt_ : 0;
  updatedAt_ = time;
  if (seenAt_ && seconds > 0) move(seconds);
  if (seen) {
    if (seenAt_ && time - *seenAt_ > options_.memory) particles_.clear();
    remember(time, robotInOdometry * seen->position);
    see(*seen, robotInOdometry);
    seenAt_ = time;
  }
  if (!seenAt_) return;
  summarize(robotInOdometry);
  estimate_.secondsSinceSeen = time - *seenAt_;
  estimate_.known = estimate_.secondsSinceSeen <= options_.memory;
}

}  // namespace modules
