// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace app {

class ArcosSimulation;
class SimulatedRun;

/// What `robotctl sim` says at its end, for programs: numbers as they are, by names that stay.
nlohmann::json figuresOf(SimulatedRun& run, double realSeconds);
nlohmann::json figuresOf(const ArcosSimulation& simulation, double realSeconds);

/// The same for people, one subject a line, rounded and with units. Takes what either of the two returns.
std::string figuresText(const nlohmann::json& figures);

}  // namespace app
