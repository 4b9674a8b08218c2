// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modules/modeling/localization/FieldMonteCarlo.h"
#include "robotlink/base/Random.h"
#include "robotlink/config/FieldDescription.h"

namespace modules {

/// A robot that walks on the field of 2002 and turns its head, with the errors that its images and its dead
/// reckoning have: what the filters of the pose are tested with, without images.
class FieldWalk {
 public:
  explicit FieldWalk(const robotlink::Pose2& start, std::uint64_t seed = 1);

  const robotlink::FieldDescription& field() const { return field_; }
  const robotlink::Pose2& pose() const { return pose_; }
  /// Moves the robot to another place unnoticed by its dead reckoning.
  void carry(const robotlink::Pose2& pose) { pose_ = pose; }
  void showLandmarks(bool show) { showsLandmarks_ = show; }
  void showLines(bool show) { showsLines_ = show; }

  /// Walks for the time of an image; the frame is valid until the next call.
  FieldMonteCarlo::Frame step();

 private:
  void seeLandmarks(double pan);
  void seeLines(double pan);

  robotlink::FieldDescription field_;
  FieldEdgeMap edges_;
  robotlink::Random random_;
  robotlink::Pose2 pose_, odometry_;
  std::vector<LandmarkMeasurement> landmarks_;
  std::vector<LineMeasurement> lines_;
  int frame_ = 0;
  bool showsLandmarks_ = true, showsLines_ = true;
};

/// How far an estimate is from a pose, m and rad.
double placeError(const PoseEstimate& estimate, const robotlink::Pose2& truth);
double headingError(const PoseEstimate& estimate, const robotlink::Pose2& truth);

}  // namespace modules
