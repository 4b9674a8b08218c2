// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "modules/navigation/OdometryHistory.h"
#include "modules/navigation/RangeBeam.h"

namespace modules {

/// What was seen around the robot during the last seconds, as points in the frame of its odometry, which is
/// good for so short a time. Sonars fire in turn and look past what is beside them, and a laser sees only one
/// half: what was seen must not be forgotten at once. A newer measurement through a point takes it away. A
/// sonar knows how far an echo came from, but hardly from where; what others found free tells. Bounded.
class RangeMemory {
 public:
  struct Options {
    double memory = 4.0;  ///< s
    double nearMemory =
        10.0;  ///< s, of what a laser saw near by: nothing else tells a corner of the robot so exactly
    double near = 1.2;   ///< m
    double reach = 5.0;  ///< m, that is remembered around the robot
    double coneMemory =
        1.5;  ///< s, that what a cone found free tells where on its arc another one's echo came from
    double sameAs = 0.25;       ///< m; an echo that a laser's ray in the cone explains so well is the laser's
    double bumperMemory = 6.0;  ///< s
  };
  explicit RangeMemory(const Options& options) : options_(options) {}

  /// Each measurement is placed where the robot was at its time; those for whose time there is no odometry
  /// are left out.
  void see(std::span<const RangeBeam> beams, const OdometryHistory& odometry);
  /// The robot pushes against something there, in the robot's frame.
  void touch(const robotlink::Vector2& placeInRobot, const robotlink::Pose2& robotInOdometry,
             robotlink::Instant now);
  /// Lets go what is too old or too far.
  void forget(robotlink::Instant now, const robotlink::Pose2& robotInOdometry);
  /// The odometry was set to another place.
  void clear() {
    points_.clear();
    freeCones_.clear();
  }

  /// In the robot's frame; those that lie as good as at the same place only once.
  std::vector<robotlink::Vector2> pointsInRobot(const robotlink::Pose2& robotInOdometry) const;
  /// When the newest measurement was made; none before the first.
  std::optional<robotlink::Instant> newest() const { return newest_; }

 private:
  enum class Source : std::uint8_t { kLaser, kSonar, kBumper };
  struct Point {
    robotlink::Vector2 place;  // in odometry
    robotlink::Instant time;
    Source source;
  };
  /// What one cone found free.
  struct FreeCone {
    robotlink::Pose2 sensor;  // in odometry
    double half = 0, range = 0;
    robotlink::Instant time;
    bool contains(const robotlink::Vector2& place) const;
  };
  void seeRays(std::span<const RangeBeam> rays, const robotlink::Pose2& robotInOdometry);
  void seeCone(const RangeBeam& cone, const robotlink::Pose2& robotInOdometry,
               std::span<const RangeBeam> rays);
  /// Some ray in the cone ended as far away.
  bool explainedByRays(const RangeBeam& cone, std::span<const RangeBeam> rays) const;
  /// Where on the arc at a cone's range its echo may have come from.
  void addArc(const FreeCone& cone);
  void add(const robotlink::Vector2& place, robotlink::Instant time, Source source);

  Options options_;
  std::vector<Point> points_;
  std::vector<RangeBeam> lastRays_;
  std::deque<FreeCone> freeCones_;
  std::optional<robotlink::Instant> newest_;
};

}  // namespace modules
