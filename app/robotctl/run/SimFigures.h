// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace app {

class ArcosSimulation;
class SimulatedRun;

/// The result of `robotctl sim` for other programs: exact numbers under stable names. `realSeconds`: the real
/// time that the run took.
nlohmann::json figuresOf(SimulatedRun& run, double realSeconds);
nlohmann::json figuresOf(const ArcosSimulation& simulation, double realSeconds);

/// The figures as a text for users: one subject per line, rounded and with units. Accepts the result of both
/// functions above.
std::string figuresText(const nlohmann::json& figures);

}  // namespace app
