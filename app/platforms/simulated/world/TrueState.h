// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotcontrol {
class RobotState;
}
namespace simcore {
class Simulation;
}

namespace app {

/// The true events of a simulated robot's body at the present step, as the oracle reports them. It
/// is picked up while nothing touches it and it is more than 10 mm above what is below it, and has fallen
/// while it is tilted by more than 45 degrees. What of it touches anything but a floor and the ball has
/// collided: a leg by its name ("front left"), any other part by that of its link. The time and the duration
/// are left unset, as all is for a robot that the simulation does not have.
robotcontrol::RobotState trueState(const simcore::Simulation& simulation, const std::string& robot);

}  // namespace app
