// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/mapping/OccupancyMap.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Vector2;

namespace {

/// The distance by which the map grows beyond a place, m.
constexpr double kRoom = 4;
/// The maximum size of a building, m.
constexpr double kFarthest = 1e4;

}  // namespace

OccupancyMap::OccupancyMap(const Options& options) : options_(options) {
  frame_.cell = options.cell;
  makeRoom(Vector2::Zero());
}

void OccupancyMap::setOptions(const Options& options) {
  options_ = options;
  options_.cell = frame_.cell;
}

bool OccupancyMap::makeRoom(const Vector2& place) {
  if (frame_.contains(frame_.column(place.x()), frame_.row(place.y()))) return true;
  if (!(place.cwiseAbs().maxCoeff() < kFarthest)) return false;
  const bool first = logOdds_.empty();
  const Vector2 high = frame_.low + frame_.cell * Vector2(frame_.width, frame_.height);
  const auto cells = [&](double meters) { return static_cast<int>(std::ceil(meters / frame_.cell)); };
  // Whole cells on each side, so that the old ones keep their places.
  const int left = first || place.x() < frame_.low.x() ? cells(frame_.low.x() - place.x() + kRoom) : 0;
  const int below = first || place.y() < frame_.low.y() ? cells(frame_.low.y() - place.y() + kRoom) : 0;
  const int right = first || place.x() >= high.x() ? cells(place.x() - high.x() + kRoom) : 0;
  const int above = first || place.y() >= high.y() ? cells(place.y() - high.y() + kRoom) : 0;
  GridFrame grown = frame_;
  grown.low -= frame_.cell * Vector2(left, below);
  grown.width += left + right;
  grown.height += below + above;
  if (grown.size() > options_.mostCells) return false;
  std::vector<std::int16_t> logOdds(grown.size(), kUnseen);
  std::vector<std::uint32_t> changedBy(grown.size(), 0);
  for (int row = 0; row < frame_.height; ++row) {
    const auto from = static_cast<std::ptrdiff_t>(frame_.index(0, row));
    const auto to = static_cast<std::ptrdiff_t>(grown.index(left, row + below));
    std::copy_n(logOdds_.begin() + from, frame_.width, logOdds.begin() + to);
    std::copy_n(changedBy_.begin() + from, frame_.width, changedBy.begin() + to);
  }
  for (Cell& cell : changes_) cell = {cell.column + left, cell.row + below};
  frame_ = grown;
  logOdds_ = std::move(logOdds);
  changedBy_ = std::move(changedBy);
  ++generation_;
  return true;
}

void OccupancyMap::add(const Vector2& place, double logOdds) {
  const int column = frame_.column(place.x()), row = frame_.row(place.y());
  if (!frame_.contains(column, row)) return;
  const std::size_t index = frame_.index(column, row);
  if (std::exchange(changedBy_[index], scan_) == scan_) return;
  std::int16_t& value = logOdds_[index];
  const bool before = value > 0;
  const double sum = (value == kUnseen ? 0 : kUnit * value) + logOdds;
  value = static_cast<std::int16_t>(std::lround(std::clamp(sum, -options_.limit, options_.limit) / kUnit));
  if (before == (value > 0)) return;
  changes_.push_back({column, row});
  ++generation_;
}

void OccupancyMap::clearAlong(const Vector2& from, const Vector2& to) {
  const double length = (to - from).norm();
  const int steps = static_cast<int>(length / (0.5 * frame_.cell));
  for (int i = 0; i < steps; ++i) add(from + (to - from) * ((i + 0.5) / steps), -options_.miss);
}

bool OccupancyMap::insert(const robotlink::Pose2& robotInMap, std::span<const RangeBeam> beams) {
  changes_.clear();
  ++scan_;
  bool all = true;
  for (const RangeBeam& beam : beams) {
    if (beam.openingAngle > 0 || !beam.hit()) continue;
    const Vector2 end = robotInMap * beam.endInRobot();
    if (makeRoom(end))
      add(end, options_.hit);
    else
      all = false;
  }
  for (const RangeBeam& beam : beams) {
    if (beam.openingAngle > 0) continue;
    // Up to the cell before the end, which a ray that hit something does not tell about.
    const double free = std::min(beam.hit() ? beam.range - frame_.cell : beam.maximum, options_.clearTo);
    if (!(free > 0)) continue;
    const robotlink::Pose2 sensor = robotInMap * beam.sensorInRobot;
    const Vector2 end = sensor * Vector2(free, 0);
    if (!makeRoom(end) || !makeRoom(sensor.translation())) all = false;
    clearAlong(sensor.translation(), end);
  }
  return all;
}

int OccupancyMap::percent(int column, int row) const {
  const std::int16_t value = logOdds_[frame_.index(column, row)];
  if (value == kUnseen) return -1;
  const double share = 1 - 1 / (1 + std::exp(kUnit * value));
  // Occupied cells are above 50 when rounded, too.
  return value > 0 ? std::max(51, static_cast<int>(std::lround(100 * share)))
                   : std::min(49, static_cast<int>(std::lround(100 * share)));
}

}  // namespace modules
