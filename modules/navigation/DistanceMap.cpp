// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/DistanceMap.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

// A value above the square of any distance in cells, and far below the limit of float.
constexpr float kNoWall = 1e12F;

/// The lower envelope of parabolas: squared distances along one line of cells. `from` and `to` have the same
/// size; the others are buffers, longer by one.
void transformLine(const std::vector<float>& from, std::vector<float>& to, std::vector<std::size_t>& peaks,
                   std::vector<float>& bounds) {
  const std::size_t size = from.size();
  std::size_t last = 0;
  peaks[0] = 0;
  bounds[0] = -kNoWall;
  bounds[1] = kNoWall;
  for (std::size_t q = 1; q < size; ++q) {
    const auto crossing = [&](std::size_t peak) {
      const float a = static_cast<float>(q), b = static_cast<float>(peak);
      return ((from[q] + a * a) - (from[peak] + b * b)) / (2 * (a - b));
    };
    float at = crossing(peaks[last]);
    while (last > 0 && at <= bounds[last]) at = crossing(peaks[--last]);
    peaks[++last] = q;
    bounds[last] = at;
    bounds[last + 1] = kNoWall;
  }
  last = 0;
  for (std::size_t q = 0; q < size; ++q) {
    while (bounds[last + 1] < static_cast<float>(q)) ++last;
    const float away = static_cast<float>(q) - static_cast<float>(peaks[last]);
    to[q] = std::min(kNoWall, from[peaks[last]] + away * away);
  }
}

}  // namespace

DistanceMap::DistanceMap(const GroundMap& map, const Options& options) {
  const GroundMap::Bounds bounds = map.bounds();
  const Vector2 margin = Vector2::Constant(std::max(0.0, options.margin));
  const Vector2 size = bounds.high - bounds.low + 2 * margin;
  frame_.low = bounds.low - margin;
  frame_.cell = std::max(options.cell, 0.01);
  // A map with a point far away must not use all memory.
  const double cells = size.x() / frame_.cell * (size.y() / frame_.cell);
  const double most = static_cast<double>(std::max<std::size_t>(options.mostCells, 100));
  if (cells > most) frame_.cell *= std::sqrt(cells / most);
  frame_.width = std::max(1, static_cast<int>(std::ceil(size.x() / frame_.cell)));
  frame_.height = std::max(1, static_cast<int>(std::ceil(size.y() / frame_.cell)));
  distances_.assign(frame_.size(), kNoWall);
  for (const GroundMap::Line& line : map.lines) occupyLine(line);
  for (const Vector2& point : map.points) occupy(point);
  for (const GroundMap::Place& place : map.places) {
    if (!options.forbidden) break;
    if (place.kind == GroundMap::Place::Kind::kForbiddenLine) occupyLine(place.extent);
    if (place.kind == GroundMap::Place::Kind::kForbiddenArea) occupyArea(place);
  }
  transform();
}

void DistanceMap::occupy(const Vector2& place) {
  const int column = frame_.column(place.x()), row = frame_.row(place.y());
  if (frame_.contains(column, row)) distances_[frame_.index(column, row)] = 0;
}

void DistanceMap::occupyLine(const GroundMap::Line& line) {
  const Vector2 way = line.to - line.from;
  const int steps = 1 + static_cast<int>(std::min(1e6, 2 * way.norm() / frame_.cell));
  for (int i = 0; i <= steps; ++i) occupy(line.from + way * (static_cast<double>(i) / steps));
}

void DistanceMap::occupyArea(const GroundMap::Place& area) {
  const Vector2 low = area.extent.from.cwiseMin(area.extent.to),
                high = area.extent.from.cwiseMax(area.extent.to);
  const Pose2 areaInMap{0, 0, area.pose.heading};
  const Pose2 mapInArea = areaInMap.inverse();
  for (int row = 0; row < frame_.height; ++row) {
    for (int column = 0; column < frame_.width; ++column) {
      const Vector2 place = mapInArea * frame_.center(column, row);
      if ((place - low).minCoeff() >= 0 && (high - place).minCoeff() >= 0)
        distances_[frame_.index(column, row)] = 0;
    }
  }
}

void DistanceMap::transform() {
  const auto width = static_cast<std::size_t>(frame_.width), height = static_cast<std::size_t>(frame_.height);
  std::vector<float> from, to, bounds(std::max(width, height) + 1);
  std::vector<std::size_t> peaks(std::max(width, height) + 1);
  from.resize(height);
  to.resize(height);
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t y = 0; y < height; ++y) from[y] = distances_[y * width + x];
    transformLine(from, to, peaks, bounds);
    for (std::size_t y = 0; y < height; ++y) distances_[y * width + x] = to[y];
  }
  from.resize(width);
  to.resize(width);
  const auto cell = static_cast<float>(frame_.cell);
  for (std::size_t y = 0; y < height; ++y) {
    const auto row = distances_.begin() + static_cast<std::ptrdiff_t>(y * width);
    std::copy_n(row, width, from.begin());
    transformLine(from, to, peaks, bounds);
    std::ranges::transform(to, row, [&](float squares) { return std::min(kFar, cell * std::sqrt(squares)); });
  }
}

double DistanceMap::range(const Pose2& sensor, double openingAngle, double maximum) const {
  // Advances along the axis by the distance that is known to be free; a wall is hit where the free disc is no
  // wider than the cone. Distances are between centers of cells, so a step leaves the last cell before a wall
  // to the cone's width, or else is made from cell to cell: a longer one could pass between the cells of a
  // slanting wall. Lengths are in cells.
  constexpr double kBeside = 1e-6;   // so that a ray does not pass exactly through corners of cells
  constexpr double kBeyond = 1e-9;   // so that rounding does not leave a ray where it is
  constexpr double kParallel = 1e9;  // to a side that is never reached
  const double half = std::sin(0.5 * openingAngle), cells = 1 / frame_.cell;
  const Vector2 direction(std::cos(sensor.heading), std::sin(sensor.heading));
  const Vector2 start =
      cells * (sensor.translation() - frame_.low) + kBeside * Vector2(-direction.y(), direction.x());
  const auto inverse = [](double d) { return d == 0 ? kParallel : 1 / d; };
  const Vector2 perCell(inverse(direction.x()), inverse(direction.y()));
  const Vector2 ahead(direction.x() >= 0 ? 1 : 0, direction.y() >= 0 ? 1 : 0);
  double way = 0;
  while (way < cells * maximum) {
    const Vector2 place = start + way * direction;
    const double x = std::floor(place.x()), y = std::floor(place.y());
    // Written so that a NaN is outside, too.
    if (!(x >= 0 && y >= 0 && x < frame_.width && y < frame_.height)) return maximum;
    const double distance = cells * at(static_cast<int>(x), static_cast<int>(y)), radius = way * half;
    if (distance <= 0) {
      const double center = direction.dot(Vector2(x + 0.5, y + 0.5) - start);
      return std::clamp(frame_.cell * center, 0.0, maximum);
    }
    if (distance - radius <= 0.5) return frame_.cell * way;
    const double free = distance - std::max(radius, 1.0);
    if (free >= 1) {
      way += free;
    } else {
      way += std::min((x + ahead.x() - place.x()) * perCell.x(), (y + ahead.y() - place.y()) * perCell.y()) +
             kBeyond;
    }
  }
  return maximum;
}

}  // namespace modules
