// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotcontrol {
class ControlReplay;
}

namespace app {

/// Whether it asks for nothing but a step or a jump in a log, so that joinMoves() may make it one with
/// another.
bool onlyMoves(const robotcontrol::ControlReplay& control);

/// Makes `first` lead to where `first` and then `second` would: of jumps the newer one counts, steps of the
/// same kind and direction add up. False, and nothing is changed, if no single move does that. Both must only
/// move.
bool joinMoves(robotcontrol::ControlReplay& first, const robotcontrol::ControlReplay& second);

}  // namespace app
