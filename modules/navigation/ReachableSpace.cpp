// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/ReachableSpace.h"

#include <algorithm>
#include <array>

namespace modules {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// kWall: no place for a robot.
constexpr std::uint8_t kWall = 0, kInside = 1, kOutside = 2;

/// Marks everything that can be reached from the cells of `open` within those marked `kInside`.
void flood(const GridFrame& frame, std::vector<std::uint8_t>& marks, std::vector<std::uint32_t> open) {
  constexpr std::array<std::array<int, 2>, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  while (!open.empty()) {
    const auto at = static_cast<int>(open.back());
    open.pop_back();
    for (const auto& step : kSteps) {
      const int column = at % frame.width + step[0], row = at / frame.width + step[1];
      if (!frame.contains(column, row)) continue;
      const std::size_t next = frame.index(column, row);
      if (marks[next] != kInside) continue;
      marks[next] = kOutside;
      open.push_back(static_cast<std::uint32_t>(next));
    }
  }
}

/// Removes cells without a wall on two or more of their four sides: in front of a gap it may be one.
void keepEnclosed(const DistanceMap& distances, std::vector<std::uint8_t>& marks) {
  const GridFrame& frame = distances.frame();
  std::vector<std::uint8_t> openSides(marks.size(), 0);
  const auto sweep = [&](int count, int length, const auto& cellOf) {
    for (int line = 0; line < count; ++line) {
      int first = length, last = -1;
      for (int i = 0; i < length; ++i) {
        const auto [column, row] = cellOf(line, i);
        if (distances.at(column, row) > 0) continue;
        first = std::min(first, i);
        last = i;
      }
      for (int i = 0; i < length; ++i) {
        const auto [column, row] = cellOf(line, i);
        openSides[frame.index(column, row)] +=
            static_cast<std::uint8_t>((i < first ? 1 : 0) + (i > last ? 1 : 0));
      }
    }
  };
  sweep(frame.height, frame.width, [](int row, int column) { return std::pair(column, row); });
  sweep(frame.width, frame.height, [](int column, int row) { return std::pair(column, row); });
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (openSides[i] > 1) marks[i] = kWall;
}

std::vector<std::uint32_t> border(const GridFrame& frame, std::vector<std::uint8_t>& marks) {
  std::vector<std::uint32_t> cells;
  for (int row = 0; row < frame.height; ++row) {
    const bool whole = row == 0 || row == frame.height - 1;
    for (int column = 0; column < frame.width; column += whole || frame.width == 1 ? 1 : frame.width - 1) {
      const std::size_t index = frame.index(column, row);
      if (marks[index] != kInside) continue;
      marks[index] = kOutside;
      cells.push_back(static_cast<std::uint32_t>(index));
    }
  }
  return cells;
}

}  // namespace

ReachableSpace::ReachableSpace(const DistanceMap& distances, const GroundMap& map, double clearance)
    : frame_(distances.frame()), inside_(frame_.size(), kWall) {
  for (int row = 0; row < frame_.height; ++row)
    for (int column = 0; column < frame_.width; ++column)
      if (distances.at(column, row) >= clearance) inside_[frame_.index(column, row)] = kInside;
  std::vector<std::uint8_t> flooded = inside_;
  keepEnclosed(distances, inside_);
  flood(frame_, flooded, border(frame_, flooded));
  const GroundMap::Place* home = map.find(GroundMap::Place::Kind::kHome);
  bool homeOutside = false;
  if (home != nullptr) {
    const int column = frame_.column(home->pose.x), row = frame_.row(home->pose.y);
    homeOutside = frame_.contains(column, row) && flooded[frame_.index(column, row)] == kOutside;
  }
  const bool closed = !homeOutside && std::ranges::find(flooded, kInside) != flooded.end();
  for (std::size_t i = 0; i < inside_.size(); ++i) {
    if (closed && flooded[i] != kInside) inside_[i] = kWall;
    if (inside_[i] == kInside) cells_.push_back(static_cast<std::uint32_t>(i));
  }
}

double ReachableSpace::area() const {
  return static_cast<double>(cells_.size()) * frame_.cell * frame_.cell;
}

bool ReachableSpace::contains(const Vector2& place) const {
  const int column = frame_.column(place.x()), row = frame_.row(place.y());
  return frame_.contains(column, row) && inside_[frame_.index(column, row)] == kInside;
}

Pose2 ReachableSpace::draw(robotlink::Random& random) const {
  const auto at = static_cast<int>(
      cells_[static_cast<std::size_t>(random.uniform() * static_cast<double>(cells_.size()))]);
  const Vector2 center = frame_.center(at % frame_.width, at / frame_.width);
  const double half = 0.5 * frame_.cell;
  return {center.x() + random.uniform(-half, half), center.y() + random.uniform(-half, half),
          random.uniform(-robotlink::kPi, robotlink::kPi)};
}

}  // namespace modules
