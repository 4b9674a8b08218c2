// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/LandmarkGeometry.h"

#include <cmath>

namespace modules {

using robotlink::Vector3;

LandmarkGeometry::LandmarkGeometry(const robotlink::FieldDescription& field, const Options& options)
    : beacon_{2 * field.beaconRadius, 2 * field.beaconBandHeight,
              field.beaconBaseHeight + field.beaconBandHeight},
      goal_{field.goalWidth, field.goalHeight, 0.5 * field.goalHeight},
      options_(options) {}

namespace {

/// Whether what is seen reaches down to the ground, as a goal does. A beacon's band in the goal's color ends
/// higher than the camera is, so the horizon is below it.
bool standsOnGround(const ImageBox& box, double depth, const CameraView& view) {
  if (box.bottom >= view.height) return true;
  const double expected = std::atan2(view.cameraInRobot.translation().z(), depth);
  return view.elevation({box.center().x(), box.bottom}) < -0.5 * expected;
}

}  // namespace

std::optional<LandmarkObservation> LandmarkGeometry::locate(const FieldLandmark& landmark,
                                                            const ImageBox& box,
                                                            const CameraView& view) const {
  const Size size = sizeOf(landmark.kind);
  const bool cutVertically = box.top <= 0 || box.bottom >= view.height;
  const bool cutSideways = box.left <= 0 || box.right >= view.width;
  if (cutSideways && (cutVertically || landmark.kind == FieldLandmark::Kind::kGoal)) return std::nullopt;
  if (box.height() < options_.minimumHeight || box.width() < 0.25 * options_.minimumHeight)
    return std::nullopt;

  const double depth =
      cutVertically ? view.focalX * size.width / box.width() : view.focalY * size.height / box.height();
  const Vector3 camera = view.cameraInRobot.translation();
  const Vector3 place = camera + view.ray(box.center()) * depth;
  const double heightTolerance = 0.5 * size.height + options_.tiltTolerance * depth;
  if (!cutVertically && std::abs(place.z() - size.middle) > heightTolerance) return std::nullopt;
  // A beacon is slim, so its shape must match, too. Goals are seen at an angle and behind posts.
  const double shape = (box.width() / view.focalX * size.height) / (box.height() / view.focalY * size.width);
  if (landmark.kind == FieldLandmark::Kind::kBeacon && !cutVertically && !cutSideways &&
      (shape < 0.4 || shape > 2.5))
    return std::nullopt;
  if (landmark.kind == FieldLandmark::Kind::kGoal && shape < 0.25) return std::nullopt;

  if (landmark.kind == FieldLandmark::Kind::kGoal && !standsOnGround(box, depth, view)) return std::nullopt;

  LandmarkObservation seen;
  seen.bearing = std::atan2(place.y(), place.x());
  seen.distance = place.head<2>().norm();
  seen.box = box;
  seen.confidence = (cutVertically || cutSideways ? 0.3 : 0.9) * std::min(1.0, box.height() / 10);
  if (seen.distance > options_.maximumDistance) return std::nullopt;
  return seen;
}

}  // namespace modules
