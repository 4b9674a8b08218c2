// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotcontrol {
class WorldObjects;
}
namespace simcore {
class Simulation;
struct CameraSensor;
}  // namespace simcore

namespace app {

/// Adds all ports of a simulation to its objects, each below the joint or the link that it belongs to; models
/// with their links and joints have to be there already.
void addPorts(const simcore::Simulation& simulation, robotcontrol::WorldObjects& to);

/// Whether a camera's robot sends its images.
bool isSentByRobot(const simcore::Simulation& simulation, const simcore::CameraSensor& camera);
/// The stream that has a camera's images: that of its robot, or, where the robot sends none, that of the
/// port.
std::string imageStreamOf(const simcore::Simulation& simulation, const simcore::CameraSensor& camera);

}  // namespace app
