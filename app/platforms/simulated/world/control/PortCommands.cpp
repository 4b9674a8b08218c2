// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/control/PortCommands.h"

#include <algorithm>
#include <cmath>

#include "robotlink/base/Spelling.h"
#include "simcore/Simulation.h"

namespace app {
namespace {

using simcore::Port;

/// The maximum number of actuators named in an error.
constexpr std::size_t kMaxNamed = 20;

std::vector<std::string> commandable(const simcore::Simulation& simulation) {
  std::vector<std::string> names;
  for (const Port& port : simulation.ports())
    if (port.isActuator() && names.size() < kMaxNamed) names.push_back(port.info.path);
  return names;
}

std::size_t sizeOf(const Port& port) {
  return port.info.shape.empty() ? 1 : static_cast<std::size_t>(port.info.shape.front());
}

}  // namespace

robotlink::Result<void> PortCommands::set(const simcore::Simulation& simulation,
                                          const std::string& controller, const std::string& port,
                                          std::vector<double> values) {
  const Port* found = simulation.port(port);
  if (found == nullptr || !found->isActuator()) {
    return robotlink::failure(
        "simulation.actuator",
        "there is no actuator " + port + robotlink::suggestion(port, commandable(simulation)), {}, {port});
  }
  const bool finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
  if (values.size() != sizeOf(*found) || !finite) {
    return robotlink::failure(
        "simulation.actuator",
        "the actuator " + port + " takes " + std::to_string(sizeOf(*found)) + " finite numbers", {}, {port});
  }
  commands_[controller][port] = {std::move(values), found->kind == Port::Kind::kDoor, false};
  return {};
}

void PortCommands::release(simcore::Simulation& simulation, const std::string& controller) {
  const auto found = commands_.find(controller);
  if (found == commands_.end()) return;
  for (const auto& [path, command] : found->second) {
    const Port* port = simulation.port(path);
    if (port == nullptr || (port->kind != Port::Kind::kDrive && port->kind != Port::Kind::kGuide)) continue;
    static_cast<void>(simulation.write(path, std::vector<double>(command.values.size(), 0.0)));
  }
  commands_.erase(found);
}

void PortCommands::apply(simcore::Simulation& simulation) {
  for (auto& [controller, ports] : commands_) {
    for (auto& [path, command] : ports) {
      const bool isStopped = std::ranges::find(stopped_, path.substr(0, path.find('/'))) != stopped_.end();
      if (isStopped || (command.isOnce && command.isDone)) continue;
      command.isDone = true;
      // The actuator may have been removed from a scene that was edited meanwhile.
      static_cast<void>(simulation.write(path, command.values));
    }
  }
}

}  // namespace app
