// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/PixelArea.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

namespace colortool {
namespace {

/// A bit mask for a part of an image, its sides inclusive, from which areas are built.
class Mask {
 public:
  Mask(int left, int top, int right, int bottom)
      : left_(left),
        top_(top),
        right_(right),
        bottom_(bottom),
        taken_(static_cast<std::size_t>(right - left + 1) * static_cast<std::size_t>(bottom - top + 1), 0) {}

  std::uint8_t& at(int x, int y) {
    return taken_[static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(right_ - left_ + 1) +
                  static_cast<std::size_t>(x - left_)];
  }
  PixelArea area() {
    PixelArea result;
    for (int y = top_; y <= bottom_; ++y) {
      for (int x = left_; x <= right_; ++x) {
        if (at(x, y) == 0) continue;
        const int begin = x;
        while (x <= right_ && at(x, y) != 0) ++x;
        result.push_back({y, begin, x});
      }
    }
    return result;
  }

 private:
  int left_, top_, right_, bottom_;
  std::vector<std::uint8_t> taken_;
};

int bounded(double value, int most) {
  return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(most)));
}

/// The squared distance of a point from a line segment.
double squaredDistance(ImagePoint from, ImagePoint to, double x, double y) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double length = dx * dx + dy * dy;
  const double along =
      length > 0 ? std::clamp(((x - from.x) * dx + (y - from.y) * dy) / length, 0.0, 1.0) : 0.0;
  const double ex = x - from.x - along * dx, ey = y - from.y - along * dy;
  return ex * ex + ey * ey;
}

/// Combines two areas row by row; `keep(inA, inB)` says whether a pixel belongs to the result.
template <typename Keep>
PixelArea combined(const PixelArea& a, const PixelArea& b, const Keep& keep) {
  PixelArea result;
  std::vector<std::array<int, 2>> ends;  // x, and which of the two areas begins or ends there
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const int y = std::min(i < a.size() ? a[i].y : b[j].y, j < b.size() ? b[j].y : a[i].y);
    ends.clear();
    for (; i < a.size() && a[i].y == y; ++i) ends.insert(ends.end(), {{a[i].begin, 1}, {a[i].end, 1}});
    for (; j < b.size() && b[j].y == y; ++j) ends.insert(ends.end(), {{b[j].begin, 2}, {b[j].end, 2}});
    std::ranges::sort(ends);
    int inside = 0, begin = 0;
    bool open = false;
    for (std::size_t k = 0; k < ends.size();) {
      const int x = ends[k][0];
      for (; k < ends.size() && ends[k][0] == x; ++k) inside ^= ends[k][1];
      const bool kept = keep((inside & 1) != 0, (inside & 2) != 0);
      if (kept && !open) begin = x;
      if (!kept && open) result.push_back({y, begin, x});
      open = kept;
    }
  }
  return result;
}

/// Grows over similar colors, the nearest pixels first.
class Wand {
 public:
  Wand(const ColorImage& image, const WandOptions& options)
      : image_(image), options_(options), mask_(0, 0, image.width - 1, image.height - 1) {}

  PixelArea grow(int x, int y) {
    take(x, y);
    while (!border_.empty() && taken_ < options_.mostPixels) {
      const auto [atX, atY] = border_.front();
      border_.pop_front();
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        look(atX, atY, atX + dx, atY + dy);
    }
    return mask_.area();
  }

 private:
  using Color = std::array<double, 3>;
  static Color weighted(const robotlink::YCbCr& color) {
    return {0.5 * color.y, static_cast<double>(color.cb), static_cast<double>(color.cr)};
  }
  static double distance(const Color& a, const Color& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  void take(int x, int y) {
    mask_.at(x, y) = 1;
    border_.emplace_back(x, y);
    const Color color = weighted(image_.at(x, y));
    for (std::size_t i = 0; i < 3; ++i) sum_[i] += color[i];
    ++taken_;
  }
  void look(int fromX, int fromY, int x, int y) {
    if (!image_.contains(x, y) || mask_.at(x, y) != 0 || taken_ >= options_.mostPixels) return;
    const Color color = weighted(image_.at(x, y));
    const Color mean = {sum_[0] / taken_, sum_[1] / taken_, sum_[2] / taken_};
    if (distance(color, mean) > options_.tolerance) return;
    if (distance(color, weighted(image_.at(fromX, fromY))) > options_.edge) return;
    take(x, y);
  }

  const ColorImage& image_;
  const WandOptions& options_;
  Mask mask_;
  std::deque<std::pair<int, int>> border_;
  Color sum_{};
  int taken_ = 0;
};

}  // namespace

PixelArea brushArea(int width, int height, std::span<const ImagePoint> points, double radius) {
  if (points.empty() || width <= 0 || height <= 0) return {};
  const auto [leftmost, rightmost] = std::ranges::minmax(points, {}, &ImagePoint::x);
  const auto [highest, lowest] = std::ranges::minmax(points, {}, &ImagePoint::y);
  const int left = std::max(0, bounded(std::ceil(leftmost.x - radius), width)),
            right = bounded(std::floor(rightmost.x + radius), width - 1),
            top = std::max(0, bounded(std::ceil(highest.y - radius), height)),
            bottom = bounded(std::floor(lowest.y + radius), height - 1);
  if (left > right || top > bottom) return {};
  Mask mask(left, top, right, bottom);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImagePoint from = points[i], to = points[std::min(i + 1, points.size() - 1)];
    const int x0 = std::max(left, bounded(std::ceil(std::min(from.x, to.x) - radius), width)),
              x1 = std::min(right, bounded(std::floor(std::max(from.x, to.x) + radius), width)),
              y0 = std::max(top, bounded(std::ceil(std::min(from.y, to.y) - radius), height)),
              y1 = std::min(bottom, bounded(std::floor(std::max(from.y, to.y) + radius), height));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        if (squaredDistance(from, to, x, y) <= radius * radius) mask.at(x, y) = 1;
      }
    }
  }
  return mask.area();
}

PixelArea carefulBrushArea(const ColorImage& image, std::span<const ImagePoint> points, double radius,
                           double tolerance) {
  // The pixels on the line are meant, whatever their color.
  const PixelArea middle = brushArea(image.width, image.height, points, std::min(radius, 0.71));
  struct Meant {
    int x, y;
  };
  std::vector<Meant> meant;
  for (const PixelRun& run : middle) {
    for (int x = run.begin; x < run.end; ++x) meant.push_back({x, run.y});
  }
  const auto isLike = [&](int x, int y) {
    const auto nearest = std::ranges::min_element(
        meant, {}, [&](const Meant& m) { return (m.x - x) * (m.x - x) + (m.y - y) * (m.y - y); });
    if (nearest == meant.end()) return true;
    const robotlink::YCbCr a = image.at(nearest->x, nearest->y), b = image.at(x, y);
    return std::hypot(0.5 * (a.y - b.y), a.cb - b.cb, a.cr - b.cr) <= tolerance;
  };
  PixelArea area;
  for (const PixelRun& run : brushArea(image.width, image.height, points, radius)) {
    for (int x = run.begin; x < run.end; ++x) {
      if (!isLike(x, run.y)) continue;
      if (!area.empty() && area.back().y == run.y && area.back().end == x)
        ++area.back().end;
      else
        area.push_back({run.y, x, x + 1});
    }
  }
  return area;
}

PixelArea rectangleArea(int width, int height, ImagePoint corner, ImagePoint opposite) {
  const int top = std::max(0, bounded(std::round(std::min(corner.y, opposite.y)), height)),
            bottom = bounded(std::round(std::max(corner.y, opposite.y)), height - 1);
  const int left = std::max(0, bounded(std::round(std::min(corner.x, opposite.x)), width)),
            right = bounded(std::round(std::max(corner.x, opposite.x)), width - 1);
  PixelArea area;
  if (left > right) return area;
  for (int y = top; y <= bottom; ++y) area.push_back({y, left, right + 1});
  return area;
}

PixelArea polygonArea(int width, int height, std::span<const ImagePoint> corners) {
  PixelArea area;
  if (corners.size() < 3) return area;
  std::vector<double> crossings;
  for (int y = 0; y < height; ++y) {
    crossings.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ImagePoint from = corners[i], to = corners[(i + 1) % corners.size()];
      if ((from.y <= y) == (to.y <= y)) continue;
      crossings.push_back(from.x + (y - from.y) * (to.x - from.x) / (to.y - from.y));
    }
    std::ranges::sort(crossings);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int begin = std::max(0, bounded(std::ceil(crossings[i]), width)),
                end = std::max(0, bounded(std::ceil(crossings[i + 1]), width));
      if (begin >= end) continue;
      if (!area.empty() && area.back().y == y && area.back().end >= begin)
        area.back().end = end;
      else
        area.push_back({y, begin, end});
    }
  }
  return area;
}

PixelArea wandArea(const ColorImage& image, int x, int y, const WandOptions& options) {
  if (!image.contains(x, y)) return {};
  return Wand(image, options).grow(x, y);
}

PixelArea spotArea(const robotlink::ImageView& classes, int x, int y) {
  if (classes.empty() || x < 0 || y < 0 || x >= classes.width || y >= classes.height) return {};
  Mask mask(0, 0, classes.width - 1, classes.height - 1);
  const std::uint8_t wanted = classes.row(y)[x];
  std::vector<std::pair<int, int>> open{{x, y}};
  mask.at(x, y) = 1;
  while (!open.empty()) {
    const auto [atX, atY] = open.back();
    open.pop_back();
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int nextX = atX + dx, nextY = atY + dy;
      if (nextX < 0 || nextY < 0 || nextX >= classes.width || nextY >= classes.height) continue;
      if (mask.at(nextX, nextY) != 0 || classes.row(nextY)[nextX] != wanted) continue;
      mask.at(nextX, nextY) = 1;
      open.emplace_back(nextX, nextY);
    }
  }
  return mask.area();
}

PixelArea united(const PixelArea& a, const PixelArea& b) {
  return combined(a, b, [](bool inA, bool inB) { return inA || inB; });
}

PixelArea without(const PixelArea& a, const PixelArea& b) {
  return combined(a, b, [](bool inA, bool inB) { return inA && !inB; });
}

std::size_t pixelCount(const PixelArea& area) {
  std::size_t count = 0;
  for (const PixelRun& run : area) count += static_cast<std::size_t>(run.end - run.begin);
  return count;
}

std::vector<PixelEdge> outline(const PixelArea& area) {
  std::vector<PixelEdge> edges;
  // Vertical sides; those of consecutive rows are joined.
  std::vector<std::pair<int, int>> sides;
  for (const PixelRun& run : area) sides.insert(sides.end(), {{run.begin, run.y}, {run.end, run.y}});
  std::ranges::sort(sides);
  for (const auto& [x, y] : sides) {
    if (!edges.empty() && edges.back().x0 == x && edges.back().y1 == y)
      ++edges.back().y1;
    else
      edges.push_back({x, y, x, y + 1});
  }
  // Horizontal sides: between a pixel of the area and one above or below that is not in it.
  PixelArea below = area;
  for (PixelRun& run : below) ++run.y;
  for (const PixelRun& run : without(area, below)) edges.push_back({run.begin, run.y, run.end, run.y});
  for (const PixelRun& run : without(below, area)) edges.push_back({run.begin, run.y, run.end, run.y});
  return edges;
}

bool contains(const PixelArea& area, int x, int y) {
  // clang 14 does not compile std::ranges::equal_range with this standard library.
  for (auto run = std::ranges::lower_bound(area, y, {}, &PixelRun::y); run != area.end() && run->y == y;
       ++run) {
    if (run->begin <= x && x < run->end) return true;
  }
  return false;
}

bool isValid(const PixelArea& area, int width, int height) {
  const PixelRun* previous = nullptr;
  for (const PixelRun& run : area) {
    if (run.y < 0 || run.y >= height || run.begin < 0 || run.begin >= run.end || run.end > width)
      return false;
    if (previous != nullptr && (run.y < previous->y || (run.y == previous->y && run.begin <= previous->end)))
      return false;
    previous = &run;
  }
  return true;
}

}  // namespace colortool
