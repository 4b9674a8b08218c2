// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modules/navigation/RangeBeam.h"

namespace foxglove {
class LaserScan;
}
namespace robotcontrol {
class SonarReadings;
}

namespace modules {

/// What sonars measured, each reading with its own time. Readings that are no number, or not above 0, are
/// left out; at most 256 of a message.
std::vector<RangeBeam> beams(const robotcontrol::SonarReadings& sonar);

/// What a laser measured, all at the time of the scan; `maximum`: m, of the laser. A range of 0, beyond the
/// maximum, or that is no number hit nothing. At most 4096 of a message.
std::vector<RangeBeam> beams(const foxglove::LaserScan& laser, double maximum);

}  // namespace modules
