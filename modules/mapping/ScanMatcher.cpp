// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/mapping/ScanMatcher.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Pose2;
using robotlink::Vector2;

namespace {

constexpr std::size_t kFewestEnds = 10;
/// The steps of the window, m and rad; the first one is not finer than a cell.
constexpr double kTurnStep = 0.0175;
/// The steps at which the refinement ends.
constexpr double kFinest = 0.004, kFinestTurn = 0.001;

}  // namespace

void ScanMatcher::makeKernel(const Options& options) {
  kernelDeviation_ = options.deviation;
  radius_ = std::clamp(static_cast<int>(std::ceil(2.5 * options.deviation / frame_.cell)), 1, 20);
  kernel_.clear();
  for (int y = -radius_; y <= radius_; ++y) {
    for (int x = -radius_; x <= radius_; ++x) {
      const double away = frame_.cell * std::hypot(x, y) / options.deviation;
      kernel_.push_back(static_cast<float>(std::exp(-0.5 * away * away)));
    }
  }
}

void ScanMatcher::stamp(int column, int row) {
  const float* value = kernel_.data();
  for (int y = row - radius_; y <= row + radius_; ++y) {
    for (int x = column - radius_; x <= column + radius_; ++x, ++value) {
      if (!frame_.contains(x, y)) continue;
      float& field = field_[frame_.index(x, y)];
      field = std::max(field, *value);
    }
  }
}

void ScanMatcher::renew(const OccupancyMap& map, int column, int row) {
  for (int y = row - radius_; y <= row + radius_; ++y) {
    for (int x = column - radius_; x <= column + radius_; ++x) {
      if (frame_.contains(x, y)) field_[frame_.index(x, y)] = 0;
    }
  }
  for (int y = row - 2 * radius_; y <= row + 2 * radius_; ++y) {
    for (int x = column - 2 * radius_; x <= column + 2 * radius_; ++x) {
      if (map.occupied(x, y)) stamp(x, y);
    }
  }
}

void ScanMatcher::follow(const OccupancyMap& map, const Options& options) {
  const GridFrame& frame = map.frame();
  const bool same = frame.width == frame_.width && frame.height == frame_.height && frame.low == frame_.low &&
                    kernelDeviation_ == options.deviation;
  if (same) {
    for (const OccupancyMap::Cell& cell : map.changes()) {
      if (map.occupied(cell.column, cell.row))
        stamp(cell.column, cell.row);
      else
        renew(map, cell.column, cell.row);
    }
    return;
  }
  frame_ = frame;
  makeKernel(options);
  field_.assign(frame_.size(), 0);
  for (int row = 0; row < frame_.height; ++row) {
    for (int column = 0; column < frame_.width; ++column) {
      if (map.occupied(column, row)) stamp(column, row);
    }
  }
}

double ScanMatcher::score(const Pose2& pose, bool smooth) const {
  const double cosine = std::cos(pose.heading), sine = std::sin(pose.heading);
  double sum = 0;
  for (const Vector2& end : ends_) {
    const double x = (pose.x + cosine * end.x() - sine * end.y() - frame_.low.x()) / frame_.cell;
    const double y = (pose.y + sine * end.x() + cosine * end.y() - frame_.low.y()) / frame_.cell;
    if (!smooth) {
      sum += fieldAt(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
      continue;
    }
    const double left = std::floor(x - 0.5), below = std::floor(y - 0.5);
    const int column = static_cast<int>(left), row = static_cast<int>(below);
    const double right = x - 0.5 - left, above = y - 0.5 - below;
    sum += (1 - above) * ((1 - right) * fieldAt(column, row) + right * fieldAt(column + 1, row)) +
           above * ((1 - right) * fieldAt(column, row + 1) + right * fieldAt(column + 1, row + 1));
  }
  return sum / static_cast<double>(ends_.size());
}

double ScanMatcher::penalty(const Offset& offset, const Options& options) const {
  const double way = std::hypot(offset.x, offset.y) / std::max(1e-6, options.reach);
  const double turn = offset.turn / std::max(1e-6, options.turnReach);
  return options.trust * (way * way + turn * turn);
}

ScanMatcher::Match ScanMatcher::bestInWindow(const Pose2& predicted, const Options& options) const {
  const int steps = static_cast<int>(options.reach / frame_.cell);
  const int turns = static_cast<int>(options.turnReach / kTurnStep);
  Match best{predicted, -1, false};
  for (int turn = -turns; turn <= turns; ++turn) {
    for (int y = -steps; y <= steps; ++y) {
      for (int x = -steps; x <= steps; ++x) {
        const Offset offset{x * frame_.cell, y * frame_.cell, turn * kTurnStep};
        const Pose2 pose{predicted.x + offset.x, predicted.y + offset.y, predicted.heading + offset.turn};
        const double value = score(pose, false) - penalty(offset, options);
        if (value > best.score) best = {pose, value, false};
      }
    }
  }
  return best;
}

void ScanMatcher::refine(Match& match, const Pose2& predicted, const Options& options) const {
  const auto valueOf = [&](const Pose2& pose) {
    const Offset offset{pose.x - predicted.x, pose.y - predicted.y,
                        robotlink::normalizedAngle(pose.heading - predicted.heading)};
    return score(pose, true) - penalty(offset, options);
  };
  match.score = valueOf(match.robotInMap);
  double step = 0.5 * frame_.cell, turn = 0.5 * kTurnStep;
  while (step > kFinest || turn > kFinestTurn) {
    const Pose2 from = match.robotInMap;
    const Pose2 beside[]{{from.x + step, from.y, from.heading}, {from.x - step, from.y, from.heading},
                         {from.x, from.y + step, from.heading}, {from.x, from.y - step, from.heading},
                         {from.x, from.y, from.heading + turn}, {from.x, from.y, from.heading - turn}};
    bool better = false;
    for (const Pose2& pose : beside) {
      const double value = valueOf(pose);
      if (value <= match.score + 1e-9) continue;
      match = {pose, value, false};
      better = true;
    }
    if (better) continue;
    step *= 0.5;
    turn *= 0.5;
  }
}

ScanMatcher::Match ScanMatcher::match(const Pose2& predicted, std::span<const RangeBeam> beams,
                                      const Options& options) {
  ends_.clear();
  std::vector<Vector2> all;
  for (const RangeBeam& beam : beams) {
    if (beam.openingAngle == 0 && beam.hit()) all.push_back(beam.endInRobot());
  }
  const std::size_t count = std::min(all.size(), static_cast<std::size_t>(std::max(1, options.rays)));
  for (std::size_t i = 0; i < count; ++i) ends_.push_back(all[i * all.size() / count]);
  if (ends_.size() < kFewestEnds || field_.empty()) return {predicted, 0, false};
  Match best = bestInWindow(predicted, options);
  refine(best, predicted, options);
  best.score = score(best.robotInMap, true);
  best.accepted = best.score >= options.leastScore;
  best.robotInMap.heading = robotlink::normalizedAngle(best.robotInMap.heading);
  if (!best.accepted) best.robotInMap = predicted;
  return best;
}

}  // namespace modules
