// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "modules/navigation/OdometryHistory.h"
#include "modules/navigation/RangeBeam.h"

namespace modules {

/// The obstacles seen around the robot during the last seconds, as points in the odometry frame, which is
/// accurate enough for such a time. They must be remembered because sonars fire in turn and miss what is
/// outside their cones, and a laser sees only one half. A newer scan replaces the laser's points within its
/// field of view; a newer cone removes points of sonars in the space that it found free. A sonar knows the
/// distance of an echo but hardly its direction; what other cones found free helps to locate it. Memory is
/// bounded. Not thread-safe.
class RangeMemory {
 public:
  struct Options {
    /// The time for which points are kept, s.
    double memory = 4.0;
    /// The same for near points of a laser, s: no other sensor shows what is at a corner of the robot so
    /// precisely.
    double nearMemory = 10.0;
    /// The distance up to which points are near, m.
    double near = 1.2;
    /// The distance from the robot up to which points are kept, m.
    double reach = 5.0;
    /// The time for which the free space of a cone helps to locate the echoes of others, s.
    double coneMemory = 1.5;
    /// An echo is not stored if a laser ray in the cone ended this close to its distance, m.
    double sameAs = 0.25;
    /// The time for which contacts of bumpers are kept, s.
    double bumperMemory = 6.0;
  };
  explicit RangeMemory(const Options& options) : options_(options) {}

  /// Adds measurements. Each is located at the robot's pose at its time; measurements without odometry for
  /// their time are dropped.
  void see(std::span<const RangeBeam> beams, const OdometryHistory& odometry);
  /// Adds a contact at a place in the robot's frame.
  void touch(const robotlink::Vector2& placeInRobot, const robotlink::Pose2& robotInOdometry,
             robotlink::Instant now);
  /// Drops points that are too old or too far away.
  void forget(robotlink::Instant now, const robotlink::Pose2& robotInOdometry);
  /// Call it when the odometry was reset.
  void clear() {
    points_.clear();
    freeCones_.clear();
  }

  /// The points in the robot's frame, m; of several at nearly the same place only one.
  std::vector<robotlink::Vector2> pointsInRobot(const robotlink::Pose2& robotInOdometry) const;
  /// The time of the newest measurement; empty before the first one.
  std::optional<robotlink::Instant> newest() const { return newest_; }

 private:
  /// The kind of sensor decides how long a point is kept.
  enum class Source : std::uint8_t { kLaser, kSonar, kBumper };
  struct Point {
    /// In the odometry frame.
    robotlink::Vector2 place;
    robotlink::Instant time;
    Source source;
  };
  /// The free space in the cone of a sonar.
  struct FreeCone {
    /// In the odometry frame.
    robotlink::Pose2 sensor;
    /// Half the field of view, rad, and the free distance, m.
    double half = 0, range = 0;
    robotlink::Instant time;
    bool contains(const robotlink::Vector2& place) const;
  };
  /// Adds the rays of a scan.
  void seeRays(std::span<const RangeBeam> rays, const robotlink::Pose2& robotInOdometry);
  /// Adds the echo of a cone, and removes points in the free space before it.
  void seeCone(const RangeBeam& cone, const robotlink::Pose2& robotInOdometry,
               std::span<const RangeBeam> rays);
  /// Whether a ray in the cone ended at about the same distance.
  bool explainedByRays(const RangeBeam& cone, std::span<const RangeBeam> rays) const;
  /// Adds points on the arc at a cone's range where its echo may have come from.
  void addArc(const FreeCone& cone);
  void add(const robotlink::Vector2& place, robotlink::Instant time, Source source);

  Options options_;
  std::vector<Point> points_;
  /// The latest scan, to explain echoes of sonars.
  std::vector<RangeBeam> lastRays_;
  /// Oldest first.
  std::deque<FreeCone> freeCones_;
  std::optional<robotlink::Instant> newest_;
};

}  // namespace modules
