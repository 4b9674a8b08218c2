// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/simulated/HeldActuators.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "robotlink/base/Spelling.h"
#include "simcore/Simulation.h"

namespace app {
namespace {

using Held = HeldActuators::Held;

/// The actuator of a port, without values; unset if there is none.
std::optional<Held> actuatorAt(const simcore::Simulation& simulation, const std::string& port) {
  const auto isIt = [&](const auto& each) { return each.info.path == port; };
  const auto servos = simulation.servos();
  if (const auto servo = std::ranges::find_if(servos, isIt); servo != servos.end())
    return Held{servo->info.robot, Held::Kind::kServo, static_cast<std::size_t>(servo - servos.begin()), {}};
  const auto drives = simulation.drives();
  if (const auto drive = std::ranges::find_if(drives, isIt); drive != drives.end())
    return Held{drive->info.robot, Held::Kind::kDrive, static_cast<std::size_t>(drive - drives.begin()), {}};
  const auto guides = simulation.guides();
  if (const auto guide = std::ranges::find_if(guides, isIt); guide != guides.end())
    return Held{guide->info.robot, Held::Kind::kGuide, static_cast<std::size_t>(guide - guides.begin()), {}};
  return std::nullopt;
}

std::vector<std::string> actuatorNames(const simcore::Simulation& simulation) {
  std::vector<std::string> names;
  for (const auto& servo : simulation.servos()) names.push_back(servo.info.path);
  for (const auto& drive : simulation.drives()) names.push_back(drive.info.path);
  for (const auto& guide : simulation.guides()) names.push_back(guide.info.path);
  return names;
}

std::size_t valuesOf(const simcore::Simulation& simulation, const Held& held) {
  if (held.kind == Held::Kind::kServo) return 1;
  if (held.kind == Held::Kind::kDrive) return 2;
  return static_cast<std::size_t>(simulation.guides()[held.index].info.shape.front());
}

/// The smallest and the largest value.
std::pair<double, double> limitsOf(const simcore::Simulation& simulation, const Held& held) {
  if (held.kind == Held::Kind::kServo) {
    const simcore::Servo& servo = simulation.servos()[held.index];
    return {servo.minimum, servo.maximum};
  }
  if (held.kind == Held::Kind::kDrive) {
    const double speed = simulation.drives()[held.index].maximumSpeed;
    return {-speed, speed};
  }
  const simcore::PortInfo& info = simulation.guides()[held.index].info;
  return {info.minimum, info.maximum};
}

void stopMoving(simcore::Simulation& simulation, const Held& held) {
  if (held.kind == Held::Kind::kDrive) simulation.requestWheelSpeeds(held.index, 0, 0);
  if (held.kind == Held::Kind::kGuide)
    simulation.guide(held.index, std::vector<double>(held.values.size(), 0));
}

}  // namespace

robotlink::Result<void> HeldActuators::hold(const simcore::Simulation& simulation, const std::string& port,
                                            const std::vector<double>& values) {
  auto held = actuatorAt(simulation, port);
  if (!held) {
    return robotlink::failure(
        "simulation.actuator",
        "there is no actuator " + port + robotlink::suggestion(port, actuatorNames(simulation)), {}, {port});
  }
  const std::size_t size = valuesOf(simulation, *held);
  if (values.size() != size) {
    return robotlink::failure("simulation.actuator",
                              "the actuator " + port + " takes " + std::to_string(size) +
                                  (size == 1 ? " value" : " values") + ", not " +
                                  std::to_string(values.size()),
                              {}, {port});
  }
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    return robotlink::failure("simulation.actuator", "the values of " + port + " are not all numbers", {},
                              {port});
  const auto [low, high] = limitsOf(simulation, *held);
  for (const double value : values) held->values.push_back(std::clamp(value, low, std::max(low, high)));
  held_[port] = *std::move(held);
  return {};
}

void HeldActuators::release(simcore::Simulation& simulation, const std::string& port) {
  const auto found = held_.find(port);
  if (found == held_.end()) return;
  stopMoving(simulation, found->second);
  held_.erase(found);
}

void HeldActuators::releaseModel(simcore::Simulation& simulation, const std::string& model) {
  std::erase_if(held_, [&](const auto& entry) {
    const bool isMeant = model.empty() || entry.second.model == model;
    if (isMeant) stopMoving(simulation, entry.second);
    return isMeant;
  });
}

void HeldActuators::apply(simcore::Simulation& simulation) const {
  for (const auto& [port, held] : held_) {
    if (held.kind == Held::Kind::kDrive) {
      simulation.requestWheelSpeeds(held.index, held.values[0], held.values[1]);
    } else if (held.kind == Held::Kind::kGuide) {
      simulation.guide(held.index, held.values);
    } else {
      simulation.setTorqueLimit(held.index, 1);
      simulation.requestAngle(held.index, held.values[0]);
    }
  }
}

}  // namespace app
