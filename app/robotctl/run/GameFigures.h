// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

namespace app {

class SimulatedRun;

/// Adds the result of a game to the figures of `robotctl sim`: the goals of each team, and with a referee the
/// score in the order of the teams, phase, half, penalties, how long robots were outside, and messages of the
/// teams. Nothing without a game.
void addGameFigures(const SimulatedRun& run, nlohmann::json& figures);

}  // namespace app
