// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the two sources that see libsdformat, whose headers take seconds to compile. No other file
// includes this.
#pragma once

#include <sdf/sdf.hh>
#include <string>

#include "robotlink/base/Error.h"
#include "simcore/world/Palette.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

inline Vector3 toEigen(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}

inline Pose3 toEigen(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  return Eigen::Translation3d(toEigen(pose.Pos())) *
         Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized();
}

/// What converting one file needs, and where its errors go.
struct SdfContext {
  const std::string& file;
  const std::string& source;  ///< the file's text
  const Palette& palette;
  robotlink::Errors& errors;

  void fail(const sdf::ElementPtr& element, std::string id, std::string text) const;
  /// Notes what libsdformat found wrong; true if that was nothing.
  bool take(const sdf::Errors& found, const sdf::ElementPtr& element) const;
  /// `value` if it lies within [minimum, maximum]; else notes an error and gives `minimum`. NaN lies nowhere.
  double within(double value, double minimum, double maximum, const std::string& what,
                const sdf::ElementPtr& element) const;
};

/// A pose in its resolved frame, checked to be finite and near.
Pose3 resolvedPose(const sdf::SemanticPose& semantic, const std::string& frame,
                   const sdf::ElementPtr& element, const SdfContext& context);
/// What a link is made of: mass, solids, pictures.
LinkDescription readLink(const sdf::Link& link, const SdfContext& context);
/// All sensors of a link that this simulator knows; others are errors.
void readSensors(const sdf::Link& link, int linkIndex, ModelDescription& model, const SdfContext& context);
/// A lidar: a laser, or, of one ray, a sensor of a distance.
void readLidar(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context);
void readSonar(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context);

/// The model's <robotcontrol:drive>, if it has one; its links and joints must have been read.
void readDrive(const sdf::Model& source, ModelDescription& model, const SdfContext& context);

}  // namespace simcore
