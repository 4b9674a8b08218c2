// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/JointLayout.h"

#include <algorithm>
#include <cmath>

namespace modules {
namespace {

constexpr std::array<const char*, 4> kHeadNames{"neckTilt", "headPan", "headRoll", "mouth"};
constexpr std::array<const char*, 4> kLegNames{"legFL", "legFR", "legHL", "legHR"};

}  // namespace

robotlink::Result<JointLayout> JointLayout::of(
    const std::vector<robotlink::RobotDescription::Joint>& joints) {
  JointLayout layout;
  layout.joints_ = joints;
  std::string missing;
  const auto find = [&](const std::string& name) {
    const auto found = std::ranges::find_if(joints, [&](const auto& joint) { return joint.name == name; });
    if (found == joints.end()) missing = name;
    return static_cast<std::size_t>(found - joints.begin());
  };
  for (std::size_t i = 0; i < kHeadNames.size(); ++i) layout.head_[i] = find(kHeadNames[i]);
  for (const Leg leg : kLegs) {
    for (std::size_t i = 0; i < 3; ++i) {
      layout.legs_[index(leg)][i] = find(kLegNames[index(leg)] + std::to_string(i + 1));
    }
  }
  if (!missing.empty()) {
    return robotlink::failure("motion.missing-joint",
                              "the robot's description lacks the joint '" + missing + "'", {}, {missing});
  }
  return layout;
}

std::vector<std::string> JointLayout::names() const {
  std::vector<std::string> names;
  for (const auto& joint : joints_) names.push_back(joint.name);
  return names;
}

std::vector<double> JointLayout::stance() const {
  std::vector<double> angles;
  for (const auto& joint : joints_) angles.push_back(joint.stance);
  return angles;
}

void JointLayout::setLeg(std::span<double> positions, Leg leg, const LegAngles& angles) const {
  const auto& joints = legs_[index(leg)];
  positions[joints[0]] = angles.swing;
  positions[joints[1]] = angles.spread;
  positions[joints[2]] = angles.knee;
}

LegAngles JointLayout::leg(std::span<const double> positions, Leg leg) const {
  const auto& joints = legs_[index(leg)];
  return {positions[joints[0]], positions[joints[1]], positions[joints[2]]};
}

HeadAngles JointLayout::head(std::span<const double> positions) const {
  return {positions[head_[0]], positions[head_[1]], positions[head_[2]], positions[head_[3]]};
}

double JointLayout::approached(std::size_t joint, double from, double target, double seconds) const {
  const auto& limits = joints_[joint];
  const double reachable = std::isfinite(target) ? std::clamp(target, limits.minimum, limits.maximum) : from;
  const double step = limits.maximumSpeed * seconds;
  return from + std::clamp(reachable - from, -step, step);
}

}  // namespace modules
