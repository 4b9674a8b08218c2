// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robotlink/arcos/server/MotionController.h"

namespace robotlink::arcos {

/// What a robot's microcontroller says of itself, and how it does what its clients may choose between. SI
/// units and radians.
///
/// The names are those by which unmodified clients take it for a simulator: ARIA looks for the serial number
/// SIM or the name MobileSim, and knows robots by their subclass.
struct ServerSettings {
  /// Who makes the heading better than skidding wheels can: nobody, the client (who asks for the gyroscope's
  /// readings), or the robot.
  enum class Gyroscope : std::uint8_t { kNone = 0, kClient = 1, kRobot = 2 };
  struct Laser {
    double startAngle = radians(-90.0),
           endAngle = radians(90.0);  ///< counter-clockwise, of the first and the last reading
    double maximum = 32.0;            ///< m
  };

  std::string name = "MobileSim";
  std::string robotClass = "Pioneer";
  std::string subclass = "p3at-sh";
  std::string serialNumber = "SIM";
  std::string firmware = "2.9";
  std::string application = "RobotControl", applicationVersion = "0";  ///< told by SIM_CTRL

  MotionParameters motion;
  Duration cycle = std::chrono::milliseconds(100);      ///< of the information packets
  Duration watchdog = std::chrono::milliseconds(2000);  ///< of silence, until it stops
  bool watchdogStops = true;

  int sonars = 16;                  ///< in arrays of eight
  double sonarMaximum = 5.0;        ///< m; also what a reading without an echo says
  bool allSonarsEachCycle = false;  ///< instead of one disc of each array after the other
  std::optional<Laser> laser = Laser{};
  int frontBumpers = 5, rearBumpers = 5;  ///< segments; 0: it has none
  Gyroscope gyroscope = Gyroscope::kClient;
  double encoderTicks = 138000;  ///< in a metre of the rim's way
  /// Information packets tell by their number whether the robot moves, as real robots do; MobileSim's never
  /// do.
  bool tellsMotion = true;
};

}  // namespace robotlink::arcos
