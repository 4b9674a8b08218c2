// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/TrueState.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robotcontrol/Perception.pb.h"
#include "simcore/Simulation.h"

namespace app {
namespace {

constexpr double kLiftedHeight = 0.01;   // m
constexpr double kLyingCosine = 0.7071;  // 45 degrees

/// The ends of the names of a leg's links, and the leg's name.
constexpr std::array<std::pair<const char*, const char*>, 4> kLegsOfLinks{
    {{"FL", "front left"}, {"FR", "front right"}, {"HL", "hind left"}, {"HR", "hind right"}}};

std::string partOf(const std::string& link) {
  const auto leg =
      std::ranges::find_if(kLegsOfLinks, [&](const auto& one) { return link.ends_with(one.first); });
  return leg == kLegsOfLinks.end() ? link : leg->second;
}

/// The side on which a robot lies if this direction of its frame, x forward and y to the left, points upward.
robotcontrol::RobotState::Side sideBelow(const robotlink::Vector3& up) {
  if (-up.z() > std::abs(up.x()) && -up.z() > std::abs(up.y())) return robotcontrol::RobotState::ON_BACK;
  if (std::abs(up.x()) > std::abs(up.y()))
    return up.x() > 0 ? robotcontrol::RobotState::ON_TAIL : robotcontrol::RobotState::ON_NOSE;
  return up.y() > 0 ? robotcontrol::RobotState::ON_RIGHT : robotcontrol::RobotState::ON_LEFT;
}

}  // namespace

robotcontrol::RobotState trueState(const simcore::Simulation& simulation, const std::string& robot) {
  robotcontrol::RobotState state;
  const auto pose = simulation.modelPose(robot);
  if (!pose) return state;
  const robotlink::Vector3 up = pose->linear().row(2);
  state.set_picked_up(simulation.heightInAir(robot) > kLiftedHeight);
  state.set_fallen(up.z() < kLyingCosine);
  if (state.fallen()) state.set_side(sideBelow(up));
  for (const std::string& link : simulation.linksAtObstacles(robot)) {
    const std::string part = partOf(link);
    if (std::ranges::find(state.collisions(), part) == state.collisions().end()) state.add_collisions(part);
  }
  return state;
}

}  // namespace app
