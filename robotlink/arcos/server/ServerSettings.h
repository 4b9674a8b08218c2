// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robotlink/arcos/server/MotionController.h"

namespace robotlink::arcos {

/// The properties of a robot that its microcontroller reports, and the variants of its behavior. SI units and
/// radians. A plain value.
///
/// The default names make unmodified clients recognize a simulator: ARIA looks for the serial number SIM or
/// the name MobileSim, and identifies robots by their subclass.
struct ServerSettings {
  /// The source of a heading better than that of the wheels: none, the client (which requests the gyroscope's
  /// readings), or the robot itself. The values are those of CONFIGpac.
  enum class Gyroscope : std::uint8_t { kNone = 0, kClient = 1, kRobot = 2 };
  /// The laser that goes over the robot's own line.
  struct Laser {
    /// The angles of the first and the last reading, rad, counterclockwise.
    double startAngle = radians(-90.0), endAngle = radians(90.0);
    /// Meters.
    double maximum = 32.0;
  };

  std::string name = "MobileSim";
  std::string robotClass = "Pioneer";
  std::string subclass = "p3at-sh";
  std::string serialNumber = "SIM";
  std::string firmware = "2.9";
  /// Reported by SIM_CTRL.
  std::string application = "RobotControl", applicationVersion = "0";

  MotionParameters motion;
  /// Interval of the information packets.
  Duration cycle = std::chrono::milliseconds(100);
  /// Silence of the client before the robot stops.
  Duration watchdog = std::chrono::milliseconds(2000);
  bool watchdogStops = true;

  /// Voltages of the battery, V: when it is full; below which it counts as low; at which the robot switches
  /// itself off.
  double fullVoltage = 13.0, lowVoltage = 11.5, shutdownVoltage = 11.0;

  /// In arrays of eight.
  int sonars = 16;
  double sonarMaximum = RobotType{}.sonarMaximum;  ///< m; also the reading if there is no echo
  /// Whether all sonars are measured each cycle, rather than one of each array after the other.
  bool allSonarsEachCycle = false;
  /// Empty if it has none.
  std::optional<Laser> laser = Laser{};
  /// Numbers of bumper segments; 0 if it has none.
  int frontBumpers = 5, rearBumpers = 5;
  Gyroscope gyroscope = Gyroscope::kClient;
  bool gripper = false;
  /// Encoder ticks per meter of the rim's travel.
  double encoderTicks = 138000;
  /// Whether the id of information packets tells if the robot moves, as on real robots; MobileSim always uses
  /// the id for standing.
  bool reportsMotion = true;
};

}  // namespace robotlink::arcos
