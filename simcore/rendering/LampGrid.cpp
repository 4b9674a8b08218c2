// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/LampGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace simcore::rendering {
namespace {

constexpr int kSize = LampGrid::kSize;
constexpr std::size_t kFaceCells = static_cast<std::size_t>(kSize) * kSize;

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
    addTriangle(corner(0), corner(1), corner(2), instance, 0);
  }
}

void LampGrid::addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                           int instance, int depth) {
  constexpr int kDeepest = 16;
  const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  const double longest = std::max({ab, bc, ca});
  const Eigen::Vector3d center = (a + b + c) / 3;
  const double cell = center.norm() / kSize;
  if (longest <= cell * cell || depth == kDeepest) {
    const double radius = std::sqrt(
        std::max({(a - center).squaredNorm(), (b - center).squaredNorm(), (c - center).squaredNorm()}));
    addSphere(static_, center, radius + 1e-9, instance, false);
    return;
  }
  if (longest == ab) {
    const Eigen::Vector3d middle = (a + b) / 2;
    addTriangle(a, middle, c, instance, depth + 1);
    addTriangle(middle, b, c, instance, depth + 1);
  } else {
    addTriangle(b, c, a, instance, depth);
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
  addSphere(cells_, sphereInWorld.center - lamp_, sphereInWorld.radius, instance, true);
}

void LampGrid::addSphere(std::vector<LampCell>& cells, const Eigen::Vector3d& center, double radius,
                         int instance, bool remember) {
  const double distance = std::max(0.0, center.norm() - radius);
  const auto bound = static_cast<float>(distance * distance * (1 - 1e-5));
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const double along = face % 2 == 0 ? center[axis] : -center[axis];
    Interval u{}, v{};
    if (!slopes(along, center[kU[axis]], radius, u) || !slopes(along, center[kV[axis]], radius, v)) continue;
    constexpr double kMargin = 0.01;
    const Rectangle r{face, cellOf(u.low, -kMargin), cellOf(u.high, kMargin), cellOf(v.low, -kMargin),
                      cellOf(v.high, kMargin)};
    for (int row = r.v0; row <= r.v1; ++row) {
      const auto start = static_cast<std::size_t>(face * kSize + row) * kSize;
      for (int column = r.u0; column <= r.u1; ++column) {
        insert(cells[start + static_cast<std::size_t>(column)], instance, bound);
      }
    }
    if (remember) touched_.push_back(r);
  }
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
