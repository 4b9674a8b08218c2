// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/LineComparison.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldEdges.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/ViewFrustum.h"
#include "robotlink/truth/PackageErrors.h"

namespace robotlink {
namespace {

/// Edges are looked at from the first distance, beyond the robot's own paws, to the second, m.
constexpr double kFromBody = 0.3, kToLines = 2;
/// How far a point may be from its edge, and one of an edge from the nearest that is reported: m, and a share
/// of the distance to the robot.
constexpr double kAtEdge = 0.1, kAtEdgeShare = 0.1;

double tolerance(double distance) {
  return kAtEdge + kAtEdgeShare * distance;
}

double distanceTo(const Vector2& start, const Vector2& end, const Vector2& point) {
  return (FieldEdge{start, end}.nearest(point) - point).norm();
}

/// The edges of a field, around a robot.
class EdgesAround {
 public:
  EdgesAround(const FieldDescription& field, const robotcontrol::OracleWorld& truth)
      : edges_(fieldEdges(field)), robot_(pose2(truth.robot_in_field())), view_(truth.camera()) {}

  struct Nearest {
    double distance = kToLines;
    /// Between its direction and that of the point, rad; of edges that meet there the one that fits best.
    double turned = 0;
  };
  /// The edge that is nearest to a point of the robot's frame; at kToLines if there is none.
  Nearest nearest(const Vector2& point, double direction = 0) const {
    constexpr double kMeet = 0.005;  // m
    const Vector2 inField = robot_ * point;
    const auto distanceOf = [&](const FieldEdge& edge) { return (edge.nearest(inField) - inField).norm(); };
    Nearest best;
    for (const FieldEdge& edge : edges_) best.distance = std::min(best.distance, distanceOf(edge));
    best.turned = kPi / 2;
    for (const FieldEdge& edge : edges_) {
      if (distanceOf(edge) > best.distance + kMeet) continue;
      best.turned =
          std::min(best.turned, std::abs(std::remainder(direction + robot_.heading - edge.direction(), kPi)));
    }
    return best;
  }
  /// Points of edges that can be seen, each 0.1 m, in the robot's frame.
  std::vector<Vector2> seen() const {
    constexpr double kStep = 0.1;
    std::vector<Vector2> points;
    for (const FieldEdge& edge : edges_) {
      const Vector2 along = edge.end - edge.start;
      const int steps = std::max(1, static_cast<int>(along.norm() / kStep));
      for (int i = 0; i <= steps; ++i) {
        const Vector2 place = robot_.inverse() * Vector2(edge.start + along * i / steps);
        const double distance = place.norm();
        if (distance >= kFromBody && distance <= kToLines && view_.shows({place.x(), place.y(), 0}))
          points.push_back(place);
      }
    }
    return points;
  }

 private:
  std::vector<FieldEdge> edges_;
  Pose2 robot_;
  ViewFrustum view_;
};

/// Counts the places that are seen and have nothing reported near them, as a function tells.
template <typename DistanceToReported>
void countMissed(const std::vector<Vector2>& seen, const DistanceToReported& distance, ErrorCounts& counts) {
  counts.there += seen.size();
  counts.missed += static_cast<std::size_t>(std::ranges::count_if(
      seen, [&](const Vector2& place) { return distance(place) > tolerance(place.norm()); }));
}

void comparePoints(const robotcontrol::FieldLinePercepts& percepts, const EdgesAround& edges,
                   const std::vector<Vector2>& seen, PackageErrors& errors) {
  for (const auto& point : percepts.points()) {
    const Vector2 place = vector2(point.position_in_robot());
    const EdgesAround::Nearest nearest = edges.nearest(place, point.direction());
    ++errors.reported;
    if (nearest.distance > tolerance(place.norm())) {
      ++errors.invented;
      continue;
    }
    errors.add("points", "m", nearest.distance);
    if (std::isfinite(point.direction())) errors.add("direction", "rad", nearest.turned);
  }
  countMissed(
      seen,
      [&](const Vector2& place) {
        double least = kToLines;
        for (const auto& point : percepts.points())
          least = std::min(least, (vector2(point.position_in_robot()) - place).norm());
        return least;
      },
      errors);
}

void compareSegments(const robotcontrol::FieldLinePercepts& percepts, const EdgesAround& edges,
                     const std::vector<Vector2>& seen, PackageErrors& errors) {
  constexpr char kSegments[] = "segments";
  // A solution that never puts points together to segments does not miss any.
  ErrorCounts& unreported = errors.unreported[kSegments];
  if (percepts.segments_size() > 0)
    errors.quantities.try_emplace(kSegments, ErrorQuantity{{}, "m", unreported});
  const auto quantity = errors.quantities.find(kSegments);
  ErrorCounts& counts = quantity == errors.quantities.end() ? unreported : quantity->second.own;
  for (const auto& segment : percepts.segments()) {
    const Vector2 start = vector2(segment.start_in_robot()), end = vector2(segment.end_in_robot());
    double sum = 0;
    bool isInvented = false;
    const Vector2 places[] = {start, 0.5 * (start + end), end};
    for (const Vector2& place : places) {
      const double distance = edges.nearest(place).distance;
      sum += distance;
      isInvented = isInvented || distance > tolerance(place.norm());
    }
    ++counts.reported;
    if (isInvented)
      ++counts.invented;
    else
      quantity->second.amounts.add(sum / 3);
  }
  countMissed(
      seen,
      [&](const Vector2& place) {
        double least = kToLines;
        for (const auto& segment : percepts.segments())
          least = std::min(
              least, distanceTo(vector2(segment.start_in_robot()), vector2(segment.end_in_robot()), place));
        return least;
      },
      counts);
}

}  // namespace

void compareLines(const robotcontrol::FieldLinePercepts& percepts, const robotcontrol::OracleWorld& truth,
                  const FieldDescription& field, PackageErrors& errors) {
  const EdgesAround edges(field, truth);
  const std::vector<Vector2> seen = edges.seen();
  comparePoints(percepts, edges, seen, errors);
  compareSegments(percepts, edges, seen, errors);
}

}  // namespace robotlink
