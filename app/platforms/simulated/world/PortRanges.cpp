// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/PortRanges.h"

#include <algorithm>
#include <string>

#include "robotlink/base/Geometry.h"
#include "robotlink/packages/PortUnits.h"
#include "simcore/Simulation.h"

namespace app {
namespace {

using simcore::Port;
using Motion = simcore::GuidedMotion;

/// The limit of what is commanded in this unit; 0 if the unit does not say it.
double motionLimit(const Motion& motion, const std::string& unit) {
  if (unit == "m/s") return motion.maximumSpeed;
  if (unit == "rad/s") return motion.maximumRate;
  return unit == "rad" ? motion.maximumSteering : 0;
}

}  // namespace

std::vector<ValueRange> rangesOf(const simcore::Simulation& simulation, const Port& port) {
  const auto numbers =
      port.info.shape.empty() ? std::size_t{1} : static_cast<std::size_t>(std::max(0, port.info.shape[0]));
  std::vector<ValueRange> ranges(numbers, {port.info.minimum, port.info.maximum});
  for (std::size_t i = 0; i < numbers; ++i) {
    const std::string unit = robotlink::unitOfNumber(port.info.unit, i, numbers);
    if (port.info.type == "battery" && unit == "share") ranges[i] = {0, 1};
    if (port.info.type == "odometry" && unit == "rad") ranges[i] = {-robotlink::kPi, robotlink::kPi};
    if (port.kind != Port::Kind::kGuide) continue;
    const double limit = motionLimit(simulation.guides()[port.index].motion, unit);
    if (limit > 0) ranges[i] = {-limit, limit};
  }
  return ranges;
}

}  // namespace app
