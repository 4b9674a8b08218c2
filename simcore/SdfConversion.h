// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the two sources that see libsdformat, whose headers take seconds to compile. No other file
// includes this.
#pragma once

#include <sdf/sdf.hh>
#include <sstream>
#include <string>

#include "simcore/SdfReader.h"

namespace simcore {

/// "0.001", not "0.001000".
inline std::string shortNumber(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

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
  const Palette& palette;
  robotlink::Errors& errors;

  void fail(const sdf::ElementPtr& element, std::string id, std::string text) const {
    const int line = element ? element->LineNumber().value_or(0) : 0;
    errors.push_back({std::move(id), std::move(text), {}, {file, line, 0}});
  }

  /// Notes what libsdformat found wrong; true if that was nothing.
  bool take(const sdf::Errors& found, const sdf::ElementPtr& element) const {
    for (const sdf::Error& error : found) {
      const int line = error.LineNumber().value_or(element ? element->LineNumber().value_or(0) : 0);
      errors.push_back({"scene.sdf", error.Message(), {}, {file, line, 0}});
    }
    return found.empty();
  }

  /// `value` if it lies within [minimum, maximum]; else notes an error and gives `minimum`. NaN lies nowhere.
  double within(double value, double minimum, double maximum, const std::string& what,
                const sdf::ElementPtr& element) const {
    if (value >= minimum && value <= maximum) return value;
    fail(element, "scene.range",
         what + " must lie between " + shortNumber(minimum) + " and " + shortNumber(maximum));
    return minimum;
  }
};

/// A pose in its resolved frame, checked to be finite and near.
Pose3 resolvedPose(const sdf::SemanticPose& semantic, const std::string& frame,
                   const sdf::ElementPtr& element, const SdfContext& context);
/// What a link is made of: mass, solids, pictures.
LinkDescription readLink(const sdf::Link& link, const SdfContext& context);
/// All sensors of a link that this simulator knows; others are errors.
void readSensors(const sdf::Link& link, int linkIndex, ModelDescription& model, const SdfContext& context);

}  // namespace simcore
