// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/lines/SegmentFinder.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Vector2;

bool SegmentFinder::follows(const LinePoint& point, const Line& line) const {
  const Vector2 to = point.inRobot - line.point;
  const double off = std::abs(to.x() * line.along.y() - to.y() * line.along.x());
  if (off > options_.tolerance + options_.tolerancePerMeter * point.inRobot.norm()) return false;
  if (!std::isfinite(point.direction)) return true;
  const double direction = std::atan2(line.along.y(), line.along.x());
  return std::abs(std::remainder(point.direction - direction, robotlink::kPi)) <= options_.directionTolerance;
}

std::vector<std::size_t>& SegmentFinder::followers(std::span<const LinePoint> points, const Line& line) {
  members_.clear();
  for (const std::size_t i : left_)
    if (follows(points[i], line)) members_.push_back(i);
  return members_;
}

SegmentFinder::Line SegmentFinder::bestLine(std::span<const LinePoint> points, robotlink::Random& random) {
  Line best;
  std::size_t most = 0;
  const auto pick = [&] {
    return left_[static_cast<std::size_t>(random.uniform() * static_cast<double>(left_.size()))];
  };
  for (int i = 0; i < options_.samples; ++i) {
    const LinePoint &first = points[pick()], &second = points[pick()];
    const Vector2 apart = second.inRobot - first.inRobot;
    if (apart.norm() < 0.05) continue;
    const Line line{first.inRobot, apart.normalized()};
    if (!follows(first, line) || !follows(second, line)) continue;
    const std::size_t votes = followers(points, line).size();
    if (votes <= most) continue;
    most = votes;
    best = line;
  }
  if (most < static_cast<std::size_t>(std::max(2, options_.minimumPoints))) best.along = Vector2::Zero();
  return best;
}

SegmentFinder::Line SegmentFinder::fitted(std::span<const LinePoint> points,
                                          std::span<const std::size_t> members) {
  Vector2 center = Vector2::Zero();
  for (const std::size_t i : members) center += points[i].inRobot;
  center /= static_cast<double>(members.size());
  double xx = 0, xy = 0, yy = 0;
  for (const std::size_t i : members) {
    const Vector2 off = points[i].inRobot - center;
    xx += off.x() * off.x();
    xy += off.x() * off.y();
    yy += off.y() * off.y();
  }
  // The principal axis of the points.
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  return {center, {std::cos(angle), std::sin(angle)}};
}

void SegmentFinder::addSegment(std::span<const LinePoint> points, const Line& line,
                               std::span<const std::size_t> members) {
  if (members.size() < static_cast<std::size_t>(std::max(2, options_.minimumPoints))) return;
  const auto place = [&](std::size_t i) { return (points[i].inRobot - line.point).dot(line.along); };
  const double start = place(members.front()), end = place(members.back());
  if (end - start < options_.minimumLength) return;
  double squares = 0;
  for (const std::size_t i : members) {
    const Vector2 to = points[i].inRobot - line.point;
    const double allowed = options_.tolerance + options_.tolerancePerMeter * points[i].inRobot.norm();
    squares += std::pow((to.x() * line.along.y() - to.y() * line.along.x()) / allowed, 2);
  }
  const auto count = static_cast<double>(members.size());
  const double closeness = std::exp(-squares / count), support = 1 - 1 / (count - 1);
  for (const std::size_t i : members) owners_[i] = static_cast<int>(segments_.size());
  segments_.push_back({line.point + start * line.along, line.point + end * line.along, closeness * support});
}

void SegmentFinder::cut(std::span<const LinePoint> points, const Line& line,
                        std::vector<std::size_t> members) {
  const auto place = [&](std::size_t i) { return (points[i].inRobot - line.point).dot(line.along); };
  std::ranges::stable_sort(members, {}, place);
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= members.size(); ++i) {
    if (i < members.size() && place(members[i]) - place(members[i - 1]) <= options_.maximumGap) continue;
    addSegment(points, line, std::span(members).subspan(begin, i - begin));
    begin = i;
  }
}

const std::vector<LineSegment>& SegmentFinder::find(std::span<const LinePoint> points) {
  segments_.clear();
  owners_.assign(points.size(), -1);
  left_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) left_.push_back(i);
  robotlink::Random random(1);
  while (left_.size() >= 2 && segments_.size() < static_cast<std::size_t>(options_.maximumSegments)) {
    const Line sampled = bestLine(points, random);
    if (sampled.along.isZero()) break;
    const Line line = fitted(points, followers(points, sampled));
    const std::vector<std::size_t> members = followers(points, line);
    if (members.size() < 2) break;
    cut(points, line, members);
    // Whatever was found, these points are not tried again.
    std::erase_if(left_, [&](std::size_t i) { return std::ranges::binary_search(members, i); });
  }
  return segments_;
}

}  // namespace modules
