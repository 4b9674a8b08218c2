// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "modules/motion/Legs.h"
#include "robotlink/base/Error.h"
#include "robotlink/config/RobotDescription.h"

namespace modules {

/// Angles of the head's joints, rad: tilt and mouth are positive upward, pan is positive to the left, roll
/// as in the robot's description.
struct HeadAngles {
  double tilt = 0, pan = 0, roll = 0, mouth = 0;
  bool operator==(const HeadAngles&) const = default;
};

/// The positions of an ERS-210's joints in the lists of its description, with their limits. Immutable.
class JointLayout {
 public:
  /// Fails if a joint of the legs or of the head is missing.
  static robotlink::Result<JointLayout> of(const std::vector<robotlink::RobotDescription::Joint>& joints);

  std::size_t size() const { return joints_.size(); }
  const robotlink::RobotDescription::Joint& joint(std::size_t i) const { return joints_[i]; }
  // In the order of the description.
  std::vector<std::string> names() const;
  std::vector<double> stance() const;

  // Access to the joints of a leg or of the head in a list of positions, rad.
  void setLeg(std::span<double> positions, Leg leg, const LegAngles& angles) const;
  LegAngles leg(std::span<const double> positions, Leg leg) const;
  HeadAngles head(std::span<const double> positions) const;
  /// Indices of tilt, pan, roll, mouth.
  const std::array<std::size_t, 4>& headJoints() const { return head_; }
  /// The index of joint J1 (number 0) to J3 (2) of a leg.
  std::size_t legJoint(Leg leg, std::size_t number) const { return legs_[index(leg)][number]; }
  /// The next angle on the way from `from` to `target` after `seconds`, within the limits of angle and speed.
  double approached(std::size_t joint, double from, double target, double seconds) const;

 private:
  std::vector<robotlink::RobotDescription::Joint> joints_;
  /// Indices by leg and joint.
  std::array<std::array<std::size_t, 3>, 4> legs_{};
  std::array<std::size_t, 4> head_{};
};

}  // namespace modules
