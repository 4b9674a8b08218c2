// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/shapes/DriveGeometry.h"

#include <algorithm>
#include <cmath>

#include "simcore/physics/shapes/LumpedLink.h"
#include "simcore/world/ModelGeometry.h"

namespace simcore {
namespace {

/// The middles of the wheels' cylinders: the links' own origins may lie anywhere.
std::vector<Vector3> wheelPlaces(const ModelDescription& model, const std::vector<int>& joints) {
  std::vector<Vector3> places;
  for (const int joint : joints) {
    const int child = model.joints[static_cast<std::size_t>(joint)].child;
    const LinkDescription& link = model.links[static_cast<std::size_t>(child)];
    places.emplace_back((link.poseInModel * link.collisions.front().poseInLink).translation());
  }
  return places;
}

Vector3 mean(const std::vector<Vector3>& places) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& place : places) sum += place;
  return sum / static_cast<double>(places.size());
}

/// How far solids extend from a point in a direction; wheels count if `withWheels`.
double reachOf(const ModelDescription& model, const Vector3& from, const Vector3& direction,
               bool withWheels) {
  const std::vector<Pose3> links = linksAtStart(model);
  double farthest = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!withWheels && isWheel(model, static_cast<int>(i))) continue;
    for (const CollisionDescription& solid : model.links[i].collisions) {
      const Pose3 pose = links[i] * solid.poseInLink;
      farthest = std::max(
          farthest, direction.dot(pose.translation() - from) + reach(solid.shape, pose.linear(), direction));
    }
  }
  return farthest;
}

}  // namespace

DriveGeometry driveGeometry(const ModelDescription& model) {
  std::vector<Vector3> wheels = wheelPlaces(model, model.drive->left);
  const std::vector<Vector3> right = wheelPlaces(model, model.drive->right);
  DriveGeometry result;
  result.toLeft = model.joints[static_cast<std::size_t>(model.drive->left[0])].axisInModel;
  const double apart = result.toLeft.dot(mean(wheels) - mean(right));
  if (apart < 0) result.toLeft = -result.toLeft;
  wheels.insert(wheels.end(), right.begin(), right.end());
  result.center = mean(wheels);
  // Over the wheels' distances from the middle: the sum of squares along, and the plain sum across.
  double along = 0, across = 0;
  for (const Vector3& wheel : wheels) {
    const Vector3 place = wheel - result.center;
    const double sideways = std::abs(place.dot(result.toLeft));
    across += sideways;
    along += place.squaredNorm() - sideways * sideways;
  }
  const auto count = static_cast<double>(wheels.size());
  result.slipRatio = slipRatioFor(model.drive->track, std::sqrt(along / count), across / count);
  if (std::abs(apart) < 1e-3) result.slipRatio = 0;

  const Vector3 forward = result.toLeft.cross(Vector3::UnitZ()).normalized();
  const auto reachTo = [&](const Vector3& direction) {
    return reachOf(model, result.center, direction, false);
  };
  const double front = reachTo(forward), back = reachTo(-forward);
  const double left = reachTo(result.toLeft), other = reachTo(-result.toLeft);
  result.footprint.center = {(front - back) / 2, (left - other) / 2};
  result.footprint.halfLength = (front + back) / 2;
  result.footprint.halfWidth = (left + other) / 2;
  constexpr int kDirections = 64;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * robotlink::kPi * i / kDirections;
    const Vector3 direction = std::cos(angle) * forward + std::sin(angle) * result.toLeft;
    result.radius = std::max(result.radius, reachOf(model, result.center, direction, true));
  }
  // Between two of the directions, solids may extend a little farther.
  result.radius /= std::cos(robotlink::kPi / kDirections);
  return result;
}

double slipRatioFor(double track, double a, double b) {
  if (a * a < 1e-6) return 1;
  return (track / 2 - b) * b / (a * a);
}

}  // namespace simcore
