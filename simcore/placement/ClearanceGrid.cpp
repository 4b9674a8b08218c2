// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/placement/ClearanceGrid.h"

#include <algorithm>
#include <cmath>

namespace simcore {
namespace {

using robotlink::Vector2;

constexpr double kMaxCells = 4e6;
/// A squared distance in cells; finite, so that differences are numbers.
constexpr float kFar = 1e12F;

/// The squared distance transform of one row or column (Felzenszwalb and Huttenlocher, "Distance Transforms
/// of Sampled Functions", 2012): the lower envelope of a parabola at each element.
class DistanceTransform {
 public:
  explicit DistanceTransform(int longest)
      : values_(static_cast<std::size_t>(longest)),
        places_(static_cast<std::size_t>(longest)),
        borders_(static_cast<std::size_t>(longest) + 1) {}

  void run(float* data, int count, int stride) {
    const auto at = [&](int i) -> float& { return data[static_cast<std::ptrdiff_t>(i) * stride]; };
    for (int i = 0; i < count; ++i) values_[static_cast<std::size_t>(i)] = at(i);
    int last = 0;
    places_[0] = 0;
    borders_[0] = -kFar;
    borders_[1] = kFar;
    for (int i = 1; i < count; ++i) {
      float border = crossing(i, place(last));
      while (border <= borders_[static_cast<std::size_t>(last)]) border = crossing(i, place(--last));
      ++last;
      places_[static_cast<std::size_t>(last)] = i;
      borders_[static_cast<std::size_t>(last)] = border;
      borders_[static_cast<std::size_t>(last) + 1] = kFar;
    }
    for (int i = 0, k = 0; i < count; ++i) {
      while (borders_[static_cast<std::size_t>(k) + 1] < static_cast<float>(i)) ++k;
      const auto distance = static_cast<float>(i - place(k));
      at(i) = distance * distance + values_[static_cast<std::size_t>(place(k))];
    }
  }

 private:
  int place(int k) const { return places_[static_cast<std::size_t>(k)]; }
  /// The position from which the parabola of a later element is lower than that of an earlier one.
  float crossing(int later, int earlier) const {
    const double a = later, b = earlier;
    const double rise = static_cast<double>(values_[static_cast<std::size_t>(later)]) -
                        static_cast<double>(values_[static_cast<std::size_t>(earlier)]);
    return static_cast<float>((rise + a * a - b * b) / (2 * (a - b)));
  }

  std::vector<float> values_;
  std::vector<int> places_;
  std::vector<float> borders_;
};

}  // namespace

ClearanceGrid::ClearanceGrid(const Vector2& low, const Vector2& high, double cellSize) : low_(low) {
  const Vector2 size = (high - low).cwiseMax(Vector2(cellSize, cellSize));
  cellSize_ = std::max(cellSize, std::sqrt(size.x() * size.y() / kMaxCells));
  // For a long and narrow floor.
  cellSize_ = std::max(cellSize_, size.maxCoeff() / kMaxCells);
  width_ = static_cast<int>(std::ceil(size.x() / cellSize_));
  height_ = static_cast<int>(std::ceil(size.y() / cellSize_));
  marks_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
}

ClearanceGrid::Cell ClearanceGrid::cellAt(const Vector2& point) const {
  const Vector2 inCells = (point - low_) / cellSize_;
  const auto number = [](double value) { return static_cast<int>(std::floor(std::clamp(value, -1e9, 1e9))); };
  return {number(inCells.x()), number(inCells.y())};
}

Vector2 ClearanceGrid::centerOf(const Cell& cell) const {
  return low_ + cellSize_ * Vector2(cell.x + 0.5, cell.y + 0.5);
}

void ClearanceGrid::mark(const Cell& cell) {
  if (contains(cell)) marks_[indexOf(cell)] = 1;
}

void ClearanceGrid::markRectangle(const robotlink::Pose2& pose, const Vector2& size) {
  // Samples half a cell apart hit every cell that the rectangle covers by more than a little.
  const Vector2 samples = (2 * size / cellSize_).array().ceil() + 1;
  if (samples.x() * samples.y() > 4.0 * width_ * height_) return markLarge(pose, size);
  const int countX = static_cast<int>(samples.x()), countY = static_cast<int>(samples.y());
  const auto share = [](int i, int count) {
    return count == 1 ? 0 : static_cast<double>(i) / (count - 1) - 0.5;
  };
  for (int i = 0; i < countX; ++i) {
    const double x = size.x() * share(i, countX);
    for (int j = 0; j < countY; ++j) mark(cellAt(pose * Vector2(x, size.y() * share(j, countY))));
  }
}

/// Marks a rectangle that is larger than the grid, perhaps by far.
void ClearanceGrid::markLarge(const robotlink::Pose2& pose, const Vector2& size) {
  const robotlink::Pose2 gridInRectangle = pose.inverse();
  const Vector2 half = size / 2 + Vector2(cellSize_, cellSize_) / 2;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const Vector2 inside = (gridInRectangle * centerOf({x, y})).cwiseAbs();
      if (inside.x() <= half.x() && inside.y() <= half.y()) mark({x, y});
    }
  }
}

void ClearanceGrid::markCircle(const Vector2& center, double radius) {
  const Cell low = cellAt(center - Vector2(radius, radius)), high = cellAt(center + Vector2(radius, radius));
  for (int y = std::max(0, low.y); y <= std::min(high.y, height_ - 1); ++y) {
    for (int x = std::max(0, low.x); x <= std::min(high.x, width_ - 1); ++x) {
      if ((centerOf({x, y}) - center).norm() <= radius + cellSize_ / 2) mark({x, y});
    }
  }
}

void ClearanceGrid::findClearances() {
  clearances_.resize(marks_.size());
  std::ranges::transform(marks_, clearances_.begin(),
                         [](std::uint8_t marked) { return marked != 0 ? 0 : kFar; });
  DistanceTransform transform(std::max(width_, height_));
  for (int y = 0; y < height_; ++y) transform.run(&clearances_[indexOf({0, y})], width_, 1);
  for (int x = 0; x < width_; ++x) transform.run(&clearances_[indexOf({x, 0})], height_, width_);
  for (float& clearance : clearances_) clearance = std::sqrt(clearance) * static_cast<float>(cellSize_);
}

}  // namespace simcore
