// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/LampGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace simcore::rendering {
namespace {

constexpr int kSize = LampGrid::kSize;
constexpr std::size_t kFaceCells = static_cast<std::size_t>(kSize) * kSize;

/// Reduces squared bounds, to allow for rounding and for the curvature of distance within a cell.
constexpr double kCaution = 1 - 1e-3;

/// The axes of u and v, by the axis of a face.
constexpr int kU[3] = {1, 0, 0};
constexpr int kV[3] = {2, 2, 1};

struct Interval {
  double low, high;
};

/// The slopes of the tangents from the origin to a circle around (along, across) in the half plane along > 0,
/// clipped to [-1, 1]; returns false if nothing is left.
bool slopes(double along, double across, double radius, Interval& result) {
  if (along + radius <= 0 || along - std::abs(across) < -1.4143 * radius) return false;
  result = {-1, 1};
  if (along <= 1.01 * radius) return true;
  const double square = along * along - radius * radius;
  const double root = radius * std::sqrt(along * along + across * across - radius * radius);
  result.low = std::max(-1.0, (along * across - root) / square);
  result.high = std::min(1.0, (along * across + root) / square);
  return result.low <= result.high;
}

/// The cell of a slope; `margin` (in cells) allows for rounding in the kernel.
int slopeCellOf(double slope, double margin) {
  return std::clamp(static_cast<int>(std::floor((slope + 1) * kSize / 2 + margin)), 0, kSize - 1);
}

std::int16_t shortIndex(int instance) {
  return instance <= std::numeric_limits<std::int16_t>::max() ? static_cast<std::int16_t>(instance)
                                                              : std::int16_t{-1};
}

void insert(LampCell& cell, std::int16_t instance, float distance) {
  if (instance == cell.nearestInstance) {
    cell.nearest = std::min(cell.nearest, distance);
  } else if (distance < cell.nearest) {
    cell.second = cell.nearest;
    cell.secondInstance = cell.nearestInstance;
    cell.nearest = distance;
    cell.nearestInstance = instance;
  } else if (distance < cell.second) {
    cell.second = distance;
    cell.secondInstance = instance;
  }
}

/// The squared distances from the lamp to a plane (points p with normal * p = offset) in the directions of a
/// row of cells' corners, from u0 to u1; infinite where the plane is not met.
void planeDistances(const Eigen::Vector3d& normal, double offset, int face, int u0, int u1, int v,
                    double* distances) {
  const int axis = face / 2;
  Eigen::Vector3d direction;
  direction[axis] = face % 2 == 0 ? 1 : -1;
  direction[kV[axis]] = 2.0 * v / kSize - 1;
  for (int u = u0; u <= u1; ++u) {
    direction[kU[axis]] = 2.0 * u / kSize - 1;
    const double t = offset / normal.dot(direction);
    *distances++ = t >= 0 ? t * t * direction.squaredNorm() : std::numeric_limits<double>::infinity();
  }
}

}  // namespace

LampGrid::LampGrid(Eigen::Vector3d lampInWorld) : lamp_(std::move(lampInWorld)) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  static_.assign(6 * kFaceCells, LampCell{kNever, kNever, -1, -1});
  cells_ = static_;
  nearest_.assign(cells_.size(), kNever);
}

void LampGrid::addStatic(const Mesh& mesh, const Pose3& meshInWorld, int instance) {
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t i) {
      return Eigen::Vector3d(meshInWorld * mesh.vertices[t[i]].cast<double>() - lamp_);
    };
    addTriangle({corner(0), corner(1), corner(2)}, instance, 0);
  }
}

/// Halves a triangle until its pieces are a few cells large.
void LampGrid::addTriangle(const Triangle& t, int instance, int depth) {
  constexpr int kDeepest = 16;
  constexpr double kCells = 4;
  const double ab = (t.b - t.a).squaredNorm(), bc = (t.c - t.b).squaredNorm(), ca = (t.a - t.c).squaredNorm();
  const double longest = std::max({ab, bc, ca});
  const double enough = kCells * 2 / kSize * (t.a + t.b + t.c).norm() / 3;
  if (longest <= enough * enough || depth == kDeepest) {
    addPiece(t, instance);
  } else if (longest == ab) {
    const Eigen::Vector3d middle = (t.a + t.b) / 2;
    addTriangle({t.a, middle, t.c}, instance, depth + 1);
    addTriangle({middle, t.b, t.c}, instance, depth + 1);
  } else {
    addTriangle({t.b, t.c, t.a}, instance, depth);
  }
}

void LampGrid::addPiece(const Triangle& t, int instance) {
  const Eigen::Vector3d center = (t.a + t.b + t.c) / 3;
  const double radius = 1e-9 + std::sqrt(std::max({(t.a - center).squaredNorm(), (t.b - center).squaredNorm(),
                                                   (t.c - center).squaredNorm()}));
  const double sphere = std::pow(std::max(0.0, center.norm() - radius), 2);
  const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a).normalized();
  Rectangle rectangles[6];
  const std::size_t count = rectanglesAround(center, radius, rectangles);
  for (const Rectangle& r : std::span(rectangles, count)) {
    // 1 / distance to a plane is linear in the direction, so its extremes in a cell are at the corners.
    std::array<double, kSize + 1> above{}, below{};
    planeDistances(normal, normal.dot(center), r.face, r.u0, r.u1 + 1, r.v0, below.data());
    for (int v = r.v0; v <= r.v1; ++v) {
      above = below;
      planeDistances(normal, normal.dot(center), r.face, r.u0, r.u1 + 1, v + 1, below.data());
      LampCell* const row = static_.data() + static_cast<std::ptrdiff_t>(r.face * kSize + v) * kSize;
      for (int u = r.u0; u <= r.u1; ++u) {
        const auto i = static_cast<std::size_t>(u - r.u0);
        const double plane = std::min({above[i], above[i + 1], below[i], below[i + 1]});
        if (std::isfinite(plane))
          insert(row[u], shortIndex(instance), static_cast<float>(std::max(sphere, plane) * kCaution));
      }
    }
  }
}

void LampGrid::restore(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    cells_[i] = static_[i];
    nearest_[i] = static_[i].nearest;
  }
}

void LampGrid::beginMoving() {
  if (!moving_) restore(0, cells_.size());
  moving_ = true;
  for (const Rectangle& r : touched_) {
    for (int v = r.v0; v <= r.v1; ++v) {
      const auto row = static_cast<std::size_t>(r.face * kSize + v) * kSize;
      restore(row + static_cast<std::size_t>(r.u0), row + static_cast<std::size_t>(r.u1) + 1);
    }
  }
  touched_.clear();
}

void LampGrid::addMoving(const Sphere& sphereInWorld, int instance) {
  const Eigen::Vector3d center = sphereInWorld.center - lamp_;
  const double distance = std::max(0.0, center.norm() - sphereInWorld.radius);
  const auto bound = static_cast<float>(distance * distance * kCaution);
  Rectangle rectangles[6];
  const std::size_t count = rectanglesAround(center, sphereInWorld.radius, rectangles);
  for (const Rectangle& r : std::span(rectangles, count)) {
    for (int v = r.v0; v <= r.v1; ++v) {
      const auto row = static_cast<std::size_t>(r.face * kSize + v) * kSize;
      for (std::size_t i = row + static_cast<std::size_t>(r.u0); i <= row + static_cast<std::size_t>(r.u1);
           ++i) {
        insert(cells_[i], shortIndex(instance), bound);
        nearest_[i] = cells_[i].nearest;
      }
    }
    touched_.push_back(r);
  }
}

/// The cells in which a sphere is seen, at most one rectangle per face; returns the number of rectangles.
std::size_t LampGrid::rectanglesAround(const Eigen::Vector3d& center, double radius,
                                       Rectangle (&rectangles)[6]) {
  std::size_t count = 0;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const double along = face % 2 == 0 ? center[axis] : -center[axis];
    Interval u{}, v{};
    if (!slopes(along, center[kU[axis]], radius, u) || !slopes(along, center[kV[axis]], radius, v)) continue;
    constexpr double kMargin = 0.01;
    rectangles[count++] = {face, slopeCellOf(u.low, -kMargin), slopeCellOf(u.high, kMargin),
                           slopeCellOf(v.low, -kMargin), slopeCellOf(v.high, kMargin)};
  }
  return count;
}

double LampGrid::nearest(const Eigen::Vector3d& pointInWorld, int withoutInstance) const {
  const Eigen::Vector3d direction = pointInWorld - lamp_;
  Eigen::Index axis = 0;
  const double largest = std::max(direction.cwiseAbs().maxCoeff(&axis), 1e-30);
  const int face = static_cast<int>(axis) * 2 + (direction[axis] < 0 ? 1 : 0);
  const int u = slopeCellOf(direction[kU[axis]] / largest, 0),
            v = slopeCellOf(direction[kV[axis]] / largest, 0);
  const LampCell& cell = cells_.data()[(face * kSize + v) * kSize + u];
  return cell.nearestInstance == withoutInstance && withoutInstance >= 0 ? cell.second : cell.nearest;
}

}  // namespace simcore::rendering
