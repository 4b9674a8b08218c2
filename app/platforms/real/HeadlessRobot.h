// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/core/platform/HeadlessRun.h"
#include "app/core/spread/OtherProgram.h"
#include "app/platforms/real/RealTimeProgram.h"

// Functions shared by all real robots that run without a window (`robotctl run`).
namespace app {

/// The names of the options in headlessRobotFields().
inline constexpr char kMapField[] = "map", kRobotField[] = "robot", kSecondsField[] = "seconds",
                      kTextsField[] = "texts", kTeamPortField[] = "team-port",
                      kTeamPeersField[] = "team-peers", kTeamField[] = "team";

/// The options --map, --robot, --seconds, --texts, --team-port, --team-peers, --team and --own-process.
/// `robot` is the robot's name if the user gives none; empty if it is not known.
std::vector<PlatformField> headlessRobotFields(const std::string& robot);
/// Puts what was chosen for the program into its options; a solution takes the place of one for the same
/// task.
void applyChoices(const HeadlessChoices& choices, RealTimeOptions& program);
/// Prints sentences about the other programs of the layout, which users should see without asking for them.
std::function<void(const std::string& text)> printSpread(const HeadlessConsole& console);
/// Serves the robot for as long as was chosen.
HeadlessServing servingOf(PlatformOpening opening, const HeadlessChoices& choices);
/// A line for each figure.
std::string figuresText(const nlohmann::json& figures);
/// Runs the part of a program that has no platform, for as long as was chosen. Fails if the program with the
/// platform was not heard.
tl::expected<HeadlessSummary, robotlink::Errors> runOtherProgram(OtherProgram::Parts parts,
                                                                 const HeadlessChoices& choices,
                                                                 const HeadlessConsole& console);

}  // namespace app
