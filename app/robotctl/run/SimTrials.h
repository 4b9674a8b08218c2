// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "app/platforms/simulated/BallTrials.h"
#include "app/platforms/simulated/WalkTrial.h"

namespace app {

class ProgramTroubles;

/// Returns the problems of programs as JSON, for the figures of a run.
nlohmann::json troublesJson(const ProgramTroubles& troubles);
/// The exit status of what ended with a status, whose programs may have been in trouble.
int withTroubles(int status, const ProgramTroubles& troubles);

/// Plays games with the ball at random places, and prints how many touched it. `troubles` hears of programs
/// in trouble. Returns an ExitStatus.
int playTrials(BallTrials trials, const ProgramTroubles& troubles, bool asJson);

/// Measures how a robot walks, and prints that. Returns an ExitStatus.
int playWalk(const WalkTrial& trial, const ProgramTroubles& troubles, bool asJson);

}  // namespace app
