// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/perception/lines/FieldLineScanner.h"
#include "robotlink/base/Random.h"

namespace modules {

/// A straight edge on the ground, in the robot's frame, m.
struct LineSegment {
  robotlink::Vector2 start = robotlink::Vector2::Zero();
  robotlink::Vector2 end = robotlink::Vector2::Zero();
  /// From 0 to 1: how many points there are on its length, and how close they are.
  double confidence = 0;
};

/// Puts points of lines together to segments by random sample consensus (Fischler, Bolles 1981): the line
/// through two points with the most other points near it whose directions agree is taken first, fitted to
/// these by least squares of the distances, and cut where it has no points for long; then the same again with
/// the points that are left. Deterministic for a seed, and for each image by itself. Buffers are reused; one
/// thread at a time.
class SegmentFinder {
 public:
  struct Options {
    /// The distance that a point may have from its line, m, plus a fraction of its distance to the robot.
    double tolerance = 0.02, tolerancePerMeter = 0.03;
    /// The difference that a point's direction may have from that of its line, rad.
    double directionTolerance = 0.5;
    /// Pairs of points that are tried for each line.
    int samples = 40;
    int minimumPoints = 4;
    /// Meters.
    double minimumLength = 0.15;
    /// Longer parts of a line without points separate two segments, m.
    double maximumGap = 0.5;
    int maximumSegments = 6;
  };
  explicit SegmentFinder(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Valid until the next call.
  const std::vector<LineSegment>& find(std::span<const LinePoint> points);
  /// For each point the index of its segment, or -1.
  const std::vector<int>& segmentOfPoint() const { return owners_; }

 private:
  /// A point on a line and its direction as a unit vector.
  struct Line {
    robotlink::Vector2 point, along;
  };
  bool follows(const LinePoint& point, const Line& line) const;
  /// The points that are left and follow a line.
  std::vector<std::size_t>& followers(std::span<const LinePoint> points, const Line& line);
  /// The line with the most followers.
  Line bestLine(std::span<const LinePoint> points, robotlink::Random& random);
  /// The line with the least squared distances from points.
  static Line fitted(std::span<const LinePoint> points, std::span<const std::size_t> members);
  /// Adds the segments of a line.
  void cut(std::span<const LinePoint> points, const Line& line, std::vector<std::size_t> members);
  void addSegment(std::span<const LinePoint> points, const Line& line, std::span<const std::size_t> members);

  Options options_;
  std::vector<LineSegment> segments_;
  std::vector<int> owners_;
  /// Indices of the points that belong to no segment yet, and of those that follow a line.
  std::vector<std::size_t> left_, members_;
};

}  // namespace modules
