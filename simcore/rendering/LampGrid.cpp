// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/LampGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace simcore::rendering {
namespace {

constexpr int kSize = LampGrid::kSize;
constexpr std::size_t kFaceCells = static_cast<std::size_t>(kSize) * kSize;

/// What squared bounds are reduced by: rounding, and the curvature of distance within a cell.
constexpr double kCaution = 1 - 1e-3;

/// The axes of a face's u and v.
constexpr int kU[3] = {1, 0, 0};
constexpr int kV[3] = {2, 2, 1};

struct Interval {
  double low, high;
};

/// The slopes of the lines from the origin that meet a circle around (along, across) in the half plane along
/// > 0, if any lie within [-1, 1].
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

/// The cell of a slope; `margin` cells are added to make up for rounding in the kernel.
int cellOf(double slope, double margin) {
  return std::clamp(static_cast<int>(std::floor((slope + 1) * kSize / 2 + margin)), 0, kSize - 1);
}

void insert(LampCell& cell, int instance, float distance) {
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

/// How near a plane (points p with normal * p = offset) comes to the lamp within a cell, squared; infinite if
/// it does not pass. 1 / distance is linear in the directions, so that the corners tell, but for the cell
/// right below the lamp.
double squaredPlaneDistance(const Eigen::Vector3d& normal, double offset, int face, int u, int v) {
  constexpr double kMargin = 0.02;
  const int axis = face / 2;
  double nearest = std::numeric_limits<double>::infinity();
  for (const double cu : {u - kMargin, u + 1 + kMargin}) {
    for (const double cv : {v - kMargin, v + 1 + kMargin}) {
      Eigen::Vector3d direction;
      direction[axis] = face % 2 == 0 ? 1 : -1;
      direction[kU[axis]] = 2 * cu / kSize - 1;
      direction[kV[axis]] = 2 * cv / kSize - 1;
      const double t = offset / normal.dot(direction);
      if (t >= 0) nearest = std::min(nearest, t * t * direction.squaredNorm());
    }
  }
  return nearest;
}

}  // namespace

LampGrid::LampGrid(const Eigen::Vector3d& lampInWorld) : lamp_(lampInWorld) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  static_.assign(6 * kFaceCells, LampCell{kNever, kNever, -1, -1});
  cells_ = static_;
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
    for (int v = r.v0; v <= r.v1; ++v) {
      for (int u = r.u0; u <= r.u1; ++u) {
        const double plane = squaredPlaneDistance(normal, normal.dot(center), r.face, u, v);
        LampCell& cell = static_[static_cast<std::size_t>((r.face * kSize + v) * kSize + u)];
        if (std::isfinite(plane))
          insert(cell, instance, static_cast<float>(std::max(sphere, plane) * kCaution));
      }
    }
  }
}

void LampGrid::beginMoving() {
  if (!moving_) cells_ = static_;
  moving_ = true;
  for (const Rectangle& r : touched_) {
    for (int v = r.v0; v <= r.v1; ++v) {
      const auto row = static_cast<std::ptrdiff_t>(r.face * kSize + v) * kSize;
      std::copy(static_.begin() + row + r.u0, static_.begin() + row + r.u1 + 1, cells_.begin() + row + r.u0);
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
      LampCell* const row = cells_.data() + static_cast<std::ptrdiff_t>(r.face * kSize + v) * kSize;
      for (int u = r.u0; u <= r.u1; ++u) insert(row[u], instance, bound);
    }
    touched_.push_back(r);
  }
}

/// The cells, at most one rectangle a face, that a sphere is seen in; returns how many rectangles.
std::size_t LampGrid::rectanglesAround(const Eigen::Vector3d& center, double radius,
                                       Rectangle (&rectangles)[6]) {
  std::size_t count = 0;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const double along = face % 2 == 0 ? center[axis] : -center[axis];
    Interval u{}, v{};
    if (!slopes(along, center[kU[axis]], radius, u) || !slopes(along, center[kV[axis]], radius, v)) continue;
    constexpr double kMargin = 0.01;
    rectangles[count++] = {face, cellOf(u.low, -kMargin), cellOf(u.high, kMargin), cellOf(v.low, -kMargin),
                           cellOf(v.high, kMargin)};
  }
  return count;
}

double LampGrid::nearest(const Eigen::Vector3d& pointInWorld, int withoutInstance) const {
  const Eigen::Vector3d direction = pointInWorld - lamp_;
  Eigen::Index axis = 0;
  const double largest = std::max(direction.cwiseAbs().maxCoeff(&axis), 1e-30);
  const int face = static_cast<int>(axis) * 2 + (direction[axis] < 0 ? 1 : 0);
  const int u = cellOf(direction[kU[axis]] / largest, 0), v = cellOf(direction[kV[axis]] / largest, 0);
  const LampCell& cell = cells_[static_cast<std::size_t>((face * kSize + v) * kSize + u)];
  return cell.nearestInstance == withoutInstance && withoutInstance >= 0 ? cell.second : cell.nearest;
}

}  // namespace simcore::rendering
