// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace robotlink::arcos {

/// The ids of commands that are used in code; commandCatalog() describes all known ones. Before a connection,
/// 0 to 2 are the SYNCs of the handshake. Units are those of the integer argument.
enum class CommandId : std::uint8_t {
  /// Keeps the robot's watchdog from stopping it; no other effect.
  kPulse = 0,
  /// Starts the information packets; sent after the handshake.
  kOpen = 1,
  /// Stops motors and information packets and ends the connection.
  kClose = 2,
  /// The handshake before a connection, with the same ids.
  kSync0 = 0,
  kSync1 = 1,
  kSync2 = 2,
  /// Firing sequence of the sonars, one byte a sonar.
  kPolling = 3,
  /// Motors on (1) or off (0).
  kEnable = 4,
  /// Acceleration, mm/s^2; negative: deceleration.
  kSetA = 5,
  /// Maximum speed, mm/s.
  kSetV = 6,
  /// Sets the odometry to 0.
  kSetO = 7,
  /// Drives a distance, mm.
  kMove = 8,
  /// Turns at a rate, deg/s.
  kRotate = 9,
  /// Maximum rotation, deg/s.
  kSetRv = 10,
  /// Drives at a speed, mm/s.
  kVel = 11,
  /// Turns to a heading of the odometry, deg.
  kHead = 12,
  /// Turns by an angle from the present heading, deg.
  kDhead = 13,
  /// Restricts turning to one direction, deg/s.
  kRotationLimit = 14,
  /// Plays tones.
  kSay = 15,
  /// Requests joystick packets: 1 one, more all the time, 0 none (the same for other requests of packets).
  kJoyRequest = 17,
  /// Requests the configuration.
  kConfig = 18,
  /// Requests encoder packets.
  kEncoder = 19,
  /// Maximum rotation in one direction, deg/s.
  kSetRvDir = 20,
  /// Turns at a rate, deg/s, as kRotate.
  kRvel = 21,
  /// Turns by an angle from the goal of the last turn, deg.
  kDchead = 22,
  /// Rotational acceleration, deg/s^2; negative: deceleration.
  kSetRa = 23,
  /// Requests packets of the inertial measurement unit.
  kImuRequest = 26,
  /// Sonar arrays on or off.
  kSonar = 28,
  /// Brakes with the normal deceleration.
  kStop = 29,
  /// Digital outputs: which, and their values.
  kDigOut = 30,
  /// Power of devices at ports: which, and their values.
  kTimer = 31,
  /// Speeds of the left and the right wheels, units of 20 mm/s.
  kVel2 = 32,
  /// Moves the gripper.
  kGripper = 33,
  /// Selects the analog port shown in information packets.
  kAdSel = 35,
  /// Value for the last gripper command.
  kGripperValue = 36,
  /// Requests gripper packets.
  kGripperRequest = 37,
  /// Simulators use 35 to 38 for the laser, with the same meaning as 230 to 233.
  kLegacyLaserEnable = 35,
  kLegacyLaserStart = 36,
  kLegacyLaserEnd = 37,
  kLegacyLaserResolution = 38,
  /// Requests packets of inputs and outputs.
  kIoRequest = 40,
  /// Servo pulse: port, and width in 0.1 ms.
  kPtuPos = 41,
  /// Sends bytes to serial port AUX1.
  kTty2 = 42,
  /// Requests bytes received at AUX1.
  kGetAux = 43,
  /// Selects the bumpers that count as stalls: 0 none, 1 front, 2 rear, 3 both.
  kBumpStall = 44,
  /// Compass packets and calibration.
  kTcm2 = 45,
  /// Whether the joystick may drive during a connection.
  kJoyDrive = 47,
  /// Time between two sonars of an array, ms.
  kSonarCycle = 48,
  /// Baud rate of the line to the client.
  kHostBaud = 50,
  /// Stops as fast as possible.
  kEStop = 55,
  /// Whether the motor button causes a stall.
  kMStall = 56,
  /// Stops at once; only simulators.
  kQStop = 57,
  /// Requests gyroscope packets, or switches a gyroscope that the robot itself uses.
  kGyro = 58,
  /// Writes to the display.
  kLcdWrite = 59,
  /// AUX3, as kTty2 and kGetAux.
  kTty4 = 60,
  kGetAux3 = 61,
  /// Requests battery packets.
  kBatteryInfo = 62,
  /// AUX2, as kTty2 and kGetAux.
  kTty3 = 66,
  kGetAux2 = 67,
  /// Gains of the rotation and the translation controllers.
  kRotKp = 82,
  kRotKv = 83,
  kRotKi = 84,
  kTransKp = 85,
  kTransKv = 86,
  kTransKi = 87,
  /// Encoder ticks of a half turn, divided by 4.
  kRevCount = 88,
  /// Difference of the wheels' sizes, 1/8192.
  kDriftFactor = 89,
  /// Sounds on or off.
  kSoundTog = 92,
  /// Encoder ticks per mm.
  kTicksMm = 93,
  /// Speed sideways, mm/s; only robots that can.
  kLatVel = 110,
  /// Acceleration sideways, mm/s^2.
  kLatAccel = 113,
  /// Ids from here to kSimExit are for simulators only. Sets the true pose; the odometry does not change.
  kSimSetPose = 224,
  /// Moves the robot back to its start, with its odometry.
  kSimReset = 225,
  /// Changes the robot's model.
  kSimModelConfig = 226,
  /// Laser off (0), plain (1) or extended (2) packets.
  kSimLaserEnable = 230,
  /// First angle of the laser's field of view, deg.
  kSimLaserStart = 231,
  /// Last angle, deg.
  kSimLaserEnd = 232,
  /// Angle between readings, 0.01 deg.
  kSimLaserResolution = 233,
  /// Operations of SimulatorControl.
  kSimControl = 236,
  /// Requests the true pose: 1 once, more all the time, 0 never.
  kSimStat = 237,
  /// Shows a text to the user.
  kSimMessage = 238,
  /// Ends the simulator.
  kSimExit = 239,
  /// Reports a given battery voltage instead of the real one.
  kBatTest = 250,
  /// Resets the controller.
  kReset = 253,
  /// Starts the controller's maintenance mode.
  kMaintenance = 255,
};

}  // namespace robotlink::arcos
