// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotcontrol {
class ControlReplay;
}

namespace app {

/// Whether a request asks for nothing but one step or jump in a log, so that joinMoves() can join it with
/// others.
bool onlyMoves(const robotcontrol::ControlReplay& control);

/// Changes `first` to a single move with the effect of `first` and then `second`: the newer one of two jumps,
/// or the sum of steps of the same kind and direction. Returns false, without a change, if there is no such
/// move. onlyMoves() must be true for both.
bool joinMoves(robotcontrol::ControlReplay& first, const robotcontrol::ControlReplay& second);

}  // namespace app
