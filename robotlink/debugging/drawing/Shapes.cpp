// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/drawing/Shapes.h"

#include <algorithm>
#include <numeric>

namespace robotlink {
namespace {

double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double twiceArea(std::span<const Vector2> corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += cross(corners[i], corners[(i + 1) % corners.size()]);
  return area;
}

bool inside(const Vector2& point, const Vector2& a, const Vector2& b, const Vector2& c) {
  return cross(b - a, point - a) >= 0 && cross(c - b, point - b) >= 0 && cross(a - c, point - c) >= 0;
}

// The remaining corners, counterclockwise.
using Ring = std::vector<std::uint32_t>;

bool isEar(std::span<const Vector2> corners, const Ring& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vector2 &a = corners[ring[(i + n - 1) % n]], &b = corners[ring[i]], &c = corners[ring[(i + 1) % n]];
  if (cross(b - a, c - b) <= 0) return false;
  for (const std::uint32_t other : ring) {
    const Vector2& point = corners[other];
    if (point != a && point != b && point != c && inside(point, a, b, c)) return false;
  }
  return true;
}

bool isConvex(std::span<const Vector2> corners, const Ring& ring) {
  double turned = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 one = corners[ring[(i + 1) % ring.size()]] - corners[ring[i]];
    const Vector2 next = corners[ring[(i + 2) % ring.size()]] - corners[ring[(i + 1) % ring.size()]];
    if (cross(one, next) < 0) return false;
    turned += std::atan2(cross(one, next), one.dot(next));
  }
  // Once around, not a star.
  return turned < 3 * kPi;
}

}  // namespace

std::vector<Vector2> ellipsePoints(const Vector2& center, const Vector2& radii, double angle) {
  constexpr int kPoints = 32;
  const Eigen::Rotation2Dd rotation(angle);
  std::vector<Vector2> points;
  points.reserve(kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double t = 2 * kPi * i / kPoints;
    points.emplace_back(center + rotation * Vector2(radii.x() * std::cos(t), radii.y() * std::sin(t)));
  }
  return points;
}

ArrowHead arrowHead(const Vector2& from, const Vector2& to, double length) {
  const Vector2 shaft = from - to;
  if (shaft.norm() < 1e-12) return {to, to};
  const Vector2 back = shaft.normalized() * length;
  return {to + Eigen::Rotation2Dd(radians(-25)) * back, to + Eigen::Rotation2Dd(radians(25)) * back};
}

std::vector<std::uint32_t> triangulate(std::span<const Vector2> corners) {
  std::vector<std::uint32_t> triangles;
  if (corners.size() < 3) return triangles;
  Ring ring(corners.size());
  std::iota(ring.begin(), ring.end(), 0U);
  if (twiceArea(corners) < 0) std::reverse(ring.begin(), ring.end());
  const bool convex = isConvex(corners, ring);
  std::size_t i = 0, misses = 0;
  for (std::size_t n = ring.size(); n > 2; n = ring.size()) {
    // A polygon that crosses itself may have no ear left; then any corner is cut, so that the loop ends.
    if (convex || misses >= n || isEar(corners, ring, i % n)) {
      const std::size_t ear = convex ? 1 : i % n;
      triangles.insert(triangles.end(), {ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
      misses = 0;
    } else {
      ++misses;
      ++i;
    }
  }
  return triangles;
}

}  // namespace robotlink
