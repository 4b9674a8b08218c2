// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotlink/arcos/sick/SickSession.h"
#include "robotlink/arcos/stream/StreamUrl.h"

namespace app {

/// The address of a Pioneer and of devices connected separately, as users write it: one of StreamUrl.h,
/// and after "?" or "&" options in any order, of which "laser" is the last:
///
///   tcp://robot:8101?robot=p3dx
///   serial:///dev/ttyUSB0?baud=38400&laser-step=0.5&laser=serial:///dev/ttyUSB1?baud=38400
///
/// robot=KIND names the description of the robot, laser=ADDRESS the line of a SICK LMS 200, whose readings
/// are laser-step=1 or 0.5 degrees apart and in laser-unit=cm (up to 80 m) or mm (up to 32 m). The laser
/// scans at the speed of its line, 38400 baud where the address says none. A plain value.
struct PioneerAddress {
  robotlink::arcos::StreamUrl line;
  /// The robot's description is resources/robots/<kind>.yaml.
  std::string kind = "p3at";
  std::optional<robotlink::arcos::StreamUrl> laser;
  robotlink::arcos::SickSession::Options scans;

  /// Parses an address; the error ("url.bad") says how to write it.
  static robotlink::Result<PioneerAddress> parse(const std::string& text);
  /// The inverse of parse(); what is as usual is left out.
  std::string text() const;
};

}  // namespace app
