// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "app/core/SimulatedWorld.h"

namespace app {

/// What a robot on wheels touched but the floor, as the simulator counts it.
inline nlohmann::json contactFigures(const SimulatedWorld& world, const std::string& robot) {
  const simcore::Simulation& simulation = world.simulation();
  return {{"name", robot},
          {"contacts", simulation.obstacleContacts(robot)},
          {"contact_seconds", robotlink::seconds(simulation.obstacleContactTime(robot))}};
}

}  // namespace app
