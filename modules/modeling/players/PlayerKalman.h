// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "modules/modeling/PlayerTracker.h"
#include "modules/modeling/players/PlayerSight.h"

namespace modules {

/// A Kalman filter over place and velocity for each other robot, in the field's frame. A percept belongs to
/// the nearest robot of its team by Mahalanobis's distance that no other percept of the image
/// belongs to, or begins a new one (Bar-Shalom, Fortmann:
/// Tracking and data association, 1988). The existence of a robot is also estimated: percepts confirm it,
/// and it is doubted where the robot looks and does not see it. Not thread-safe.
class PlayerKalman {
 public:
  struct Options {
    /// Deviation of a percept along its ray, m, plus this for each meter of distance; and across it, rad.
    double deviationNear = 0.08, deviationPerMeter = 0.15, bearingDeviation = 0.08;
    /// Standard deviation of accelerations, m/s^2, and the rate at which velocities decay, 1/s.
    double acceleration = 0.3, friction = 1;
    /// Percepts farther away than this many standard deviations are of another robot.
    double gate = 3;
    /// Half-life of the confidence, s: where nobody looks, and where the robot looks and sees nobody.
    double halfLife = 4, seenHalfLife = 0.8;
    /// Robots with less confidence are removed.
    double forgetBelow = 0.1;
    /// Robots of a team nearer to each other than this are merged, m.
    double apart = 0.3;
    int maximumPlayers = 4;
  };
  explicit PlayerKalman(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame.
  void update(const PlayerFrame& frame);
  /// Sorted by decreasing confidence.
  const std::vector<TrackedPlayer>& players() const { return players_; }

  /// x, y, vx, vy in the field, m and m/s, of the player at the same index.
  struct Track {
    std::string team;
    Eigen::Vector4d state = Eigen::Vector4d::Zero();
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
    double confidence = 0;
    /// The player was seen in the current image.
    bool seen = false;
  };
  const std::vector<Track>& tracks() const { return tracks_; }

 private:
  void predict(Track& track, double seconds) const;
  Eigen::Matrix2d covarianceOf(const PlayerSight& sight, const PlayerFrame& frame) const;
  void see(const PlayerSight& sight, const PlayerFrame& frame);
  void mergeTracks();

  Options options_;
  std::vector<Track> tracks_;
  std::vector<TrackedPlayer> players_;
  double updatedAt_ = 0;
  bool began_ = false;
};

}  // namespace modules
