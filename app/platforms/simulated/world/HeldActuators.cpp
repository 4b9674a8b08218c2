// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/HeldActuators.h"

#include <algorithm>
#include <cmath>

#include "app/platforms/simulated/world/PortRanges.h"
#include "robotlink/base/Spelling.h"
#include "simcore/Simulation.h"

namespace app {
namespace {

using simcore::Port;

std::vector<std::string> actuatorNames(const simcore::Simulation& simulation) {
  std::vector<std::string> names;
  for (const Port& port : simulation.ports()) {
    if (port.isActuator()) names.push_back(port.info.path);
  }
  return names;
}

std::size_t valuesOf(const Port& port) {
  return port.info.shape.empty() ? 1 : static_cast<std::size_t>(port.info.shape.front());
}

/// Ends the motion of what was held.
void stopMoving(simcore::Simulation& simulation, const std::string& path) {
  const Port* port = simulation.port(path);
  if (port == nullptr) return;
  using Control = simcore::MotorControl::Kind;
  const bool isMotor =
      port->kind == Port::Kind::kServo && simulation.servos()[port->index].control.kind != Control::kPosition;
  if (port->kind != Port::Kind::kDrive && port->kind != Port::Kind::kGuide && !isMotor) return;
  const std::vector<double> nothing(valuesOf(*port));
  static_cast<void>(simulation.write(path, nothing));
}

}  // namespace

robotlink::Result<void> HeldActuators::hold(const simcore::Simulation& simulation, const std::string& path,
                                            const std::vector<double>& values) {
  const Port* port = simulation.port(path);
  if (port == nullptr || !port->isActuator()) {
    return robotlink::failure(
        "simulation.actuator",
        "there is no actuator " + path + robotlink::suggestion(path, actuatorNames(simulation)), {}, {path});
  }
  const std::size_t size = valuesOf(*port);
  if (values.size() != size) {
    return robotlink::failure("simulation.actuator",
                              "the actuator " + path + " takes " + std::to_string(size) +
                                  (size == 1 ? " value" : " values") + ", not " +
                                  std::to_string(values.size()),
                              {}, {path});
  }
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    return robotlink::failure("simulation.actuator", "the values of " + path + " are not all numbers", {},
                              {path});
  Held held{port->info.robot, values};
  const std::vector<ValueRange> ranges = rangesOf(simulation, *port);
  for (std::size_t i = 0; i < size; ++i) {
    if (ranges[i].isKnown()) held.values[i] = std::clamp(values[i], ranges[i].minimum, ranges[i].maximum);
  }
  held_[path] = std::move(held);
  return {};
}

void HeldActuators::release(simcore::Simulation& simulation, const std::string& port) {
  const auto found = held_.find(port);
  if (found == held_.end()) return;
  stopMoving(simulation, port);
  held_.erase(found);
}

void HeldActuators::releaseModel(simcore::Simulation& simulation, const std::string& model) {
  std::erase_if(held_, [&](const auto& entry) {
    const bool isMeant = model.empty() || entry.second.model == model;
    if (isMeant) stopMoving(simulation, entry.first);
    return isMeant;
  });
}

void HeldActuators::forgetMissing(const simcore::Simulation& simulation) {
  std::erase_if(held_, [&](const auto& entry) {
    const Port* port = simulation.port(entry.first);
    return port == nullptr || !port->isActuator() || valuesOf(*port) != entry.second.values.size();
  });
}

void HeldActuators::apply(simcore::Simulation& simulation) const {
  for (const auto& [path, held] : held_) {
    const Port* port = simulation.port(path);
    if (port == nullptr) continue;
    if (port->kind == Port::Kind::kServo) simulation.setTorqueLimit(port->index, 1);
    static_cast<void>(simulation.write(path, held.values));
  }
}

}  // namespace app
