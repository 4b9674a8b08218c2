// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedPlatform::create(): the choice of a simulated robot's platform. It is in a source of its own since
// the platforms include SimulatedPlatform.h.
#include "app/platforms/simulated/SimulatedDrivePlatform.h"
#include "app/platforms/simulated/SimulatedJointPlatform.h"
#include "app/platforms/simulated/SimulatedWheelPlatform.h"

namespace app {

robotlink::Result<std::unique_ptr<SimulatedPlatform>> SimulatedPlatform::create(
    SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description) {
  if (description.drive && world.pioneer(robot) != nullptr)
    return SimulatedDrivePlatform::create(world, std::move(robot), description);
  if (description.drive) return SimulatedWheelPlatform::create(world, std::move(robot), description);
  return SimulatedJointPlatform::create(world, std::move(robot), description);
}

}  // namespace app
