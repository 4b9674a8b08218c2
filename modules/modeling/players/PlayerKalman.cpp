// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/players/PlayerKalman.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace modules {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using robotlink::Vector2;

void PlayerKalman::predict(Track& track, double seconds) const {
  if (seconds <= 0) return;
  const double decay = std::exp(-options_.friction * seconds);
  Matrix4d transition = Matrix4d::Identity();
  transition(0, 2) = transition(1, 3) = seconds;
  transition(2, 2) = transition(3, 3) = decay;
  track.state = transition * track.state;
  const double a = options_.acceleration * options_.acceleration, s2 = seconds * seconds;
  Matrix4d noise = Matrix4d::Zero();
  noise.topLeftCorner<2, 2>() = Matrix2d::Identity() * (0.25 * a * s2 * s2 + 1e-4 * seconds);
  noise.topRightCorner<2, 2>() = noise.bottomLeftCorner<2, 2>() =
      Matrix2d::Identity() * (0.5 * a * s2 * seconds);
  noise.bottomRightCorner<2, 2>() = Matrix2d::Identity() * (a * s2);
  track.covariance = transition * track.covariance * transition.transpose() + noise;
}

Matrix2d PlayerKalman::covarianceOf(const PlayerSight& sight, const PlayerFrame& frame) const {
  const double doubt = 1 + (1 - sight.confidence), distance = sight.positionInRobot.norm();
  const double along = std::hypot(doubt * (options_.deviationNear + options_.deviationPerMeter * distance),
                                  std::min(0.3, frame.positionDeviation));
  const double turn = std::hypot(doubt * options_.bearingDeviation, std::min(0.3, frame.headingDeviation));
  const double across =
      std::hypot(doubt * options_.deviationNear + turn * distance, std::min(0.3, frame.positionDeviation));
  const double heading =
      frame.robotInField.heading + std::atan2(sight.positionInRobot.y(), sight.positionInRobot.x());
  Matrix2d axes;
  axes << std::cos(heading), -std::sin(heading), std::sin(heading), std::cos(heading);
  const Eigen::Vector2d variances(along * along, across * across);
  return axes * variances.asDiagonal() * axes.transpose();
}

void PlayerKalman::see(const PlayerSight& sight, const PlayerFrame& frame) {
  const Vector2 measured = frame.robotInField * sight.positionInRobot;
  const Matrix2d noise = covarianceOf(sight, frame);
  Track* nearest = nullptr;
  double least = options_.gate * options_.gate;
  for (Track& track : tracks_) {
    if (track.team != sight.team) continue;
    const Matrix2d innovation = track.covariance.topLeftCorner<2, 2>() + noise;
    const Vector2 off = measured - track.state.head<2>();
    const double distance = off.dot(innovation.inverse() * off);
    // Two percepts of an image are two robots, but for patches of one robot that are close to each other.
    if (distance >= least || (track.seen && off.norm() > options_.apart)) continue;
    least = distance;
    nearest = &track;
  }
  if (nearest == nullptr) {
    Track track{sight.team, Eigen::Vector4d::Zero(), Matrix4d::Zero(), 0.5 * sight.confidence, true};
    track.state.head<2>() = measured;
    track.covariance.topLeftCorner<2, 2>() = noise;
    track.covariance.bottomRightCorner<2, 2>() = Matrix2d::Identity() * 0.01;
    tracks_.push_back(track);
    return;
  }
  const Matrix2d innovation = nearest->covariance.topLeftCorner<2, 2>() + noise;
  const Eigen::Matrix<double, 4, 2> gain = nearest->covariance.leftCols<2>() * innovation.inverse();
  nearest->state += gain * (measured - nearest->state.head<2>());
  nearest->covariance -= (gain * nearest->covariance.topRows<2>()).eval();
  nearest->seen = true;
  nearest->confidence = 1 - (1 - nearest->confidence) * (1 - 0.5 * sight.confidence);
}

void PlayerKalman::mergeTracks() {
  std::ranges::stable_sort(tracks_, std::ranges::greater(), &Track::confidence);
  std::vector<Track> kept;
  for (const Track& track : tracks_) {
    std::ptrdiff_t ofTeam = 0;
    bool same = false;
    for (const Track& other : kept) {
      if (other.team != track.team) continue;
      ++ofTeam;
      same = same || (other.state.head<2>() - track.state.head<2>()).norm() < options_.apart;
    }
    if (!same && track.confidence >= options_.forgetBelow && ofTeam < options_.maximumPlayers)
      kept.push_back(track);
  }
  tracks_ = std::move(kept);
}

void PlayerKalman::update(const PlayerFrame& frame) {
  const double seconds = began_ ? std::max(0.0, frame.time - updatedAt_) : 0;
  updatedAt_ = frame.time;
  began_ = true;
  for (Track& track : tracks_) {
    predict(track, seconds);
    track.seen = false;
    const bool inView = frame.sector.contains(track.state.head<2>());
    track.confidence *= std::exp2(-seconds / (inView ? options_.seenHalfLife : options_.halfLife));
  }
  for (const PlayerSight& sight : frame.seen) see(sight, frame);
  mergeTracks();
  players_.clear();
  for (const Track& track : tracks_)
    players_.push_back({track.team, Vector2(track.state.head<2>()), track.confidence});
}

}  // namespace modules
