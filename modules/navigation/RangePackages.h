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

/// Converts sonar readings, each with its own timestamp. Readings that are not positive finite numbers are
/// dropped; at most 256 per message.
std::vector<RangeBeam> beams(const robotcontrol::SonarReadings& sonar);

/// Converts a laser scan; all rays have its timestamp. `maximum` is the laser's range, m. A reading that is
/// 0, larger than the maximum or not finite means that nothing was hit. At most 4096 per message.
std::vector<RangeBeam> beams(const foxglove::LaserScan& laser, double maximum);

}  // namespace modules
