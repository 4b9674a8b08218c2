// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "modules/motion/LegKinematics.h"
#include "robotlink/base/Error.h"
#include "robotlink/config/RobotDescription.h"

namespace modules {

/// Angles of the head's joints, rad: tilt and mouth positive upwards, pan to the left, roll as in the robot's
/// description.
struct HeadAngles {
  double tilt = 0, pan = 0, roll = 0, mouth = 0;
  bool operator==(const HeadAngles&) const = default;
};

/// Where the joints of an ERS-210 stand in the lists of its description, and what they can do. Immutable.
class JointLayout {
 public:
  /// Fails if a joint of the legs or the head is missing.
  static robotlink::Result<JointLayout> of(const std::vector<robotlink::RobotDescription::Joint>& joints);

  std::size_t size() const { return joints_.size(); }
  const robotlink::RobotDescription::Joint& joint(std::size_t i) const { return joints_[i]; }
  std::vector<std::string> names() const;
  std::vector<double> stance() const;

  void setLeg(std::span<double> positions, Leg leg, const LegAngles& angles) const;
  LegAngles leg(std::span<const double> positions, Leg leg) const;
  void setHead(std::span<double> positions, const HeadAngles& angles) const;
  HeadAngles head(std::span<const double> positions) const;
  /// Tilt, pan, roll, mouth.
  const std::array<std::size_t, 4>& headJoints() const { return head_; }
  std::size_t legJoint(Leg leg, std::size_t number) const { return legs_[index(leg)][number]; }
  /// One step of `seconds` towards `target`, within the limits of angle and speed.
  double approached(std::size_t joint, double from, double target, double seconds) const;

 private:
  std::vector<robotlink::RobotDescription::Joint> joints_;
  std::array<std::array<std::size_t, 3>, 4> legs_{};
  std::array<std::size_t, 4> head_{};
};

}  // namespace modules
