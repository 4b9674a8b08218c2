// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/SeenObstacles.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Instant;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

constexpr double kObstacleCell = 0.1;
constexpr std::size_t kMaxEntries = 20'000;
/// A place needs at most this many passing rays to be free again, however often it was seen.
constexpr int kMaxHits = 12;

}  // namespace

SeenObstacles::SeenObstacles(const DistanceMap& walls) : walls_(walls), frame_(walls.frame()) {
  frame_.cell = std::max(kObstacleCell, walls.frame().cell);
  const double shrink = walls.frame().cell / frame_.cell;
  frame_.width = std::max(1, static_cast<int>(std::ceil(walls.frame().width * shrink)));
  frame_.height = std::max(1, static_cast<int>(std::ceil(walls.frame().height * shrink)));
  marked_.assign(frame_.size(), false);
}

std::size_t SeenObstacles::cellOf(const Vector2& place) const {
  const int column = frame_.column(place.x()), row = frame_.row(place.y());
  return frame_.contains(column, row) ? frame_.index(column, row) : frame_.size();
}

void SeenObstacles::clear() {
  for (const auto& [cell, entry] : entries_) marked_[cell] = false;
  if (!entries_.empty()) ++generation_;
  entries_.clear();
}

void SeenObstacles::end(std::size_t cell, Instant time, const Options& options) {
  if (!marked_[cell] && entries_.size() >= kMaxEntries) return;
  marked_[cell] = true;
  Entry& entry = entries_[cell];
  entry.seen = time;
  entry.hits = std::min(kMaxHits, entry.hits + 1);
  if (entry.counts || entry.hits < options.confirmedBy) return;
  entry.counts = true;
  ++generation_;
}

void SeenObstacles::pass(std::size_t cell) {
  const auto found = entries_.find(cell);
  if (--found->second.hits > 0) return;
  if (found->second.counts) ++generation_;
  marked_[cell] = false;
  entries_.erase(found);
}

void SeenObstacles::see(Instant time, const Pose2& robotInMap, std::span<const RangeBeam> beams,
                        const Options& options) {
  if (time < last_) clear();
  last_ = time;
  const double step = 0.5 * frame_.cell;
  for (const RangeBeam& beam : beams) {
    if (beam.openingAngle > 0) continue;
    const Pose2 sensor = robotInMap * beam.sensorInRobot;
    // A cell before its end a ray may graze what it ends at.
    const double free = std::min(beam.range, options.range) - 1.5 * frame_.cell;
    std::size_t before = frame_.size();
    for (double way = 0; way < free; way += step) {
      const std::size_t cell = cellOf(sensor * Vector2(way, 0));
      if (cell != before && cell < frame_.size() && marked_[cell]) pass(cell);
      before = cell;
    }
    if (!beam.hit() || beam.range > options.range) continue;
    const Vector2 place = robotInMap * beam.endInRobot();
    const std::size_t cell = cellOf(place);
    if (cell < frame_.size() && walls_.at(place) > options.wallDistance) end(cell, time, options);
  }
  const auto memory = robotlink::fromSeconds(options.memory);
  std::erase_if(entries_, [&](const auto& entry) {
    if (time - entry.second.seen <= memory) return false;
    if (entry.second.counts) ++generation_;
    marked_[entry.first] = false;
    return true;
  });
}

std::vector<Vector2> SeenObstacles::places() const {
  std::vector<Vector2> result;
  for (const auto& [cell, entry] : entries_) {
    if (!entry.counts) continue;
    const int at = static_cast<int>(cell);
    result.push_back(frame_.center(at % frame_.width, at / frame_.width));
  }
  return result;
}

}  // namespace modules
