// SPDX-License-Identifier: GPL-3.0-or-later
// Validates requests to the referee of a simulated game, for the table of RequestKinds.cpp.
#pragma once

#include <string>

namespace robotcontrol {
class Request;
class TeamRadioSettings;
}  // namespace robotcontrol

namespace robotlink {

/// The largest values of TeamRadioSettings: m, and s.
inline constexpr double kMaxRadioRange = 1000, kMaxRadioDelay = 10;
/// The most goals that a team can be given.
inline constexpr unsigned kMaxGoals = 99;

/// Returns the problem with settings of the radio between robots of a team, as a sentence; empty if valid.
std::string wrongRadio(const robotcontrol::TeamRadioSettings& radio);
/// The same of a whole request.
std::string wrongGame(const robotcontrol::Request& request);

}  // namespace robotlink
