// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/CommandTable.h"

#include <algorithm>
#include <array>

namespace robotlink::arcos {
namespace {

using Type = ArgumentType;

constexpr CommandInfo kCommands[] = {
    {0, "PULSE", Type::kNone, "", "Tells that the client is alive; SYNC0 before a connection."},
    {1, "OPEN", Type::kUnsigned, "",
     "Starts the robot's servers and its information packets; SYNC1 before a connection."},
    {2, "CLOSE", Type::kUnsigned, "",
     "Stops motors and information packets and ends the connection; SYNC2 before a connection."},
    {3, "POLLING", Type::kString, "",
     "Sonar firing sequence: one byte a sonar, from 1; empty turns all off."},
    {4, "ENABLE", Type::kUnsigned, "", "1 turns the motors on, 0 off."},
    {5, "SETA", Type::kSigned, "mm/s2", "Acceleration, or deceleration if negative."},
    {6, "SETV", Type::kUnsigned, "mm/s", "Maximum speed, and that of MOVE."},
    {7, "SETO", Type::kNone, "", "The place where the robot is becomes its odometry's origin."},
    {8, "MOVE", Type::kSigned, "mm", "Drives so far at the maximum speed, backwards if negative."},
    {9, "ROTATE", Type::kSigned, "deg/s", "Turns at that rate, counter-clockwise if positive."},
    {10, "SETRV", Type::kUnsigned, "deg/s", "Maximum rate of turning, and that of HEAD and DHEAD."},
    {11, "VEL", Type::kSigned, "mm/s", "Drives at that speed, backwards if negative."},
    {12, "HEAD", Type::kSigned, "deg", "Turns to that heading of its odometry."},
    {13, "DHEAD", Type::kSigned, "deg",
     "Turns by that much from its heading, counter-clockwise if positive."},
    {14, "DROTATE", Type::kSigned, "deg/s",
     "Limits turning to one direction: counter-clockwise if positive; 0 removes the limit, 1 and -1 block."},
    {15, "SAY", Type::kString, "", "Plays tones: pairs of duration (20 ms) and tone."},
    {17, "JOYREQUEST", Type::kUnsigned, "", "Joystick packets: 1 one, more all the time, 0 none."},
    {18, "CONFIG", Type::kUnsigned, "", "Asks for the configuration."},
    {19, "ENCODER", Type::kUnsigned, "", "Encoder packets: 1 one, more all the time, 0 none."},
    {20, "SETRVDIR", Type::kSigned, "deg/s",
     "Maximum rate of turning in one direction: counter-clockwise if positive."},
    {21, "RVEL", Type::kSigned, "deg/s", "Turns at that rate, counter-clockwise if positive."},
    {22, "DCHEAD", Type::kSigned, "deg", "Turns by that much from the last heading that was asked for."},
    {23, "SETRA", Type::kSigned, "deg/s2", "Acceleration of turning, or deceleration if negative."},
    {24, "GYRORANGE", Type::kUnsigned, "", "Range of the gyroscope."},
    {25, "GYRORATELIMIT", Type::kUnsigned, "0.1 deg/s", "Rate past which the gyroscope is not trusted."},
    {26, "IMUREQUEST", Type::kUnsigned, "",
     "Inertial measurements: 1 one packet, more all the time, 0 none."},
    {27, "IMUWRITE", Type::kBytePair, "", "Writes a register of the inertial measurement unit."},
    {28, "SONAR", Type::kUnsigned, "",
     "1 turns all sonars on, 0 off; else bit 0 says on or off and bits 1 to 4 which array."},
    {29, "STOP", Type::kNone, "", "Brakes to a stop; the motors stay on."},
    {30, "DIGOUT", Type::kBytePair, "", "Digital outputs: high byte which to change, low byte their values."},
    {31, "TIMER", Type::kBytePair, "",
     "Power of what is attached to ports: high byte which, low byte the values."},
    {32, "VEL2", Type::kBytePair, "20 mm/s", "Speeds of the wheels: high byte left, low byte right."},
    {33, "GRIPPER", Type::kUnsigned, "",
     "1 open, 2 close, 3 stop, 4 lift up, 5 lift down, 6 lift stop, 7 store, 8 deploy, 15 halt."},
    {34, "KICK", Type::kUnsigned, "ms", "A pulse on digital output 0."},
    {35, "ADSEL", Type::kUnsigned, "",
     "Which analog port information packets show; simulators: the laser, 1 plain, 2 extended, 0 off."},
    {36, "GRIPPERVAL", Type::kSigned, "",
     "Value of the gripper's last command; simulators: the angle (deg) at which the laser begins."},
    {37, "GRIPREQUEST", Type::kSigned, "",
     "Gripper packets: 1 one, more all the time, 0 none; simulators: the angle (deg) at which the laser "
     "ends."},
    {38, "GYROCALCW", Type::kUnsigned, "",
     "Calibration of the gyroscope clockwise; simulators: the laser's angle (0.01 deg) between readings."},
    {39, "GYROCALCCW", Type::kUnsigned, "", "Calibration of the gyroscope counter-clockwise."},
    {40, "IOREQUEST", Type::kUnsigned, "", "Input and output packets: 1 one, more all the time, 0 none."},
    {41, "PTUPOS", Type::kBytePair, "", "Servo pulse: high byte the port, low byte its width (0.1 ms)."},
    {42, "TTY2", Type::kString, "", "Sends to serial port AUX1."},
    {43, "GETAUX", Type::kUnsigned, "bytes",
     "How many bytes from AUX1 to send as a packet; 0 forgets what came."},
    {44, "BUMPSTALL", Type::kUnsigned, "", "Which bumpers count as stall: 0 none, 1 front, 2 rear, 3 both."},
    {45, "TCM2", Type::kUnsigned, "",
     "Compass: 0 off, 1 in information packets, 2 one packet, 3 all the time, 4 to 7 calibration."},
    {46, "JOYINFO", Type::kUnsigned, "", "Joystick packets of older robots."},
    {47, "JOYDRIVE", Type::kUnsigned, "",
     "1 lets the joystick drive while a client is connected, 0 does not."},
    {48, "SONARCYCLE", Type::kUnsigned, "ms", "Time between two sonars of an array, 2 to 120."},
    {49, "MOVINGBLINK", Type::kUnsigned, "", "1 blinks while moving."},
    {50, "HOSTBAUD", Type::kUnsigned, "",
     "Rate of the line to the client: 0 is 9600, 1 19200, 2 38400, 3 57600, 4 115200."},
    {51, "AUX1BAUD", Type::kUnsigned, "", "Rate of AUX1, as HOSTBAUD."},
    {52, "AUX2BAUD", Type::kUnsigned, "", "Rate of AUX2, as HOSTBAUD."},
    {53, "AUX3BAUD", Type::kUnsigned, "", "Rate of AUX3, as HOSTBAUD."},
    {54, "LOWBATTERY", Type::kUnsigned, "0.1 V", "Voltage at which the battery counts as low."},
    {55, "E_STOP", Type::kNone, "", "Stops at once, whatever the deceleration."},
    {56, "M_STALL", Type::kUnsigned, "", "1: the motors' button causes a stall."},
    {57, "QSTOP", Type::kNone, "", "Stops at once; simulators."},
    {58, "GYRO", Type::kUnsigned, "",
     "Gyroscope packets: 1 one, more all the time, 0 none; a gyroscope that the robot uses itself: 1 on, 0 "
     "off."},
    {59, "LCDWRITE", Type::kString, "", "Writes to the display: column, row, whether to clear, text."},
    {60, "TTY4", Type::kString, "", "Sends to serial port AUX3."},
    {61, "GETAUX3", Type::kUnsigned, "bytes",
     "How many bytes from AUX3 to send as a packet; 0 forgets what came."},
    {62, "BATTERYINFO", Type::kUnsigned, "", "Battery packets: 1 one, 2 all the time, 0 none."},
    {65, "CALCOMP", Type::kUnsigned, "", "Calibration of the compass."},
    {66, "TTY3", Type::kString, "", "Sends to serial port AUX2."},
    {67, "GETAUX2", Type::kUnsigned, "bytes",
     "How many bytes from AUX2 to send as a packet; 0 forgets what came."},
    {68, "CHARGE", Type::kUnsigned, "", "1 deploys the docking mechanism, 0 releases it."},
    {70, "ARM_INFO", Type::kUnsigned, "", "Arm: asks for its description."},
    {71, "ARM_STATUS", Type::kUnsigned, "", "Arm: packets of its state; 1 one, more all the time, 0 none."},
    {72, "ARM_INIT", Type::kNone, "", "Arm: initialises it."},
    {73, "ARM_CHECK", Type::kNone, "", "Arm: checks it."},
    {74, "ARM_POWER", Type::kUnsigned, "", "Arm: power on (1) or off (0)."},
    {75, "ARM_HOME", Type::kUnsigned, "", "Arm: moves joints home."},
    {76, "ARM_PARK", Type::kNone, "", "Arm: parks it."},
    {77, "ARM_POS", Type::kBytePair, "",
     "Arm: a joint's position; high byte the joint, low byte the position."},
    {78, "ARM_SPEED", Type::kBytePair, "", "Arm: a joint's speed."},
    {79, "ARM_STOP", Type::kUnsigned, "", "Arm: stops joints."},
    {80, "ARM_AUTOPARK", Type::kUnsigned, "s", "Arm: parks after so long without command."},
    {81, "ARM_GRIPPARK", Type::kUnsigned, "s", "Arm: parks its gripper after so long without command."},
    {82, "ROTKP", Type::kUnsigned, "", "Proportional gain of turning."},
    {83, "ROTKV", Type::kUnsigned, "", "Differential gain of turning."},
    {84, "ROTKI", Type::kUnsigned, "", "Integral gain of turning."},
    {85, "TRANSKP", Type::kUnsigned, "", "Proportional gain of driving."},
    {86, "TRANSKV", Type::kUnsigned, "", "Differential gain of driving."},
    {87, "TRANSKI", Type::kUnsigned, "", "Integral gain of driving."},
    {88, "REVCOUNT", Type::kUnsigned, "ticks", "Encoder ticks of a turn by half a circle, over 4."},
    {89, "DRIFTFACTOR", Type::kSigned, "1/8192", "Difference of the sizes of left and right wheels."},
    {90, "SOUND", Type::kUnsigned, "", "Plays a stored sound."},
    {91, "PLAYLIST", Type::kUnsigned, "", "Asks for the list of sounds."},
    {92, "SOUNDTOG", Type::kUnsigned, "", "1 turns sounds on, 0 off."},
    {93, "TICKSMM", Type::kUnsigned, "ticks/mm", "Encoder ticks of a millimetre."},
    {95, "POWER_PC", Type::kUnsigned, "", "Power of the computer."},
    {96, "POWER_LRF", Type::kUnsigned, "", "Power of the laser."},
    {97, "POWER_5V", Type::kUnsigned, "", "Power of the 5 V supply."},
    {98, "POWER_12V", Type::kUnsigned, "", "Power of the 12 V supply."},
    {102, "FREESPACE", Type::kUnsigned, "", "Display of the space that is free."},
    {110, "LATVEL", Type::kSigned, "mm/s", "Drives sideways; robots that can."},
    {113, "LATACCEL", Type::kSigned, "mm/s2", "Acceleration sideways, or deceleration if negative."},
    {117, "SEEKUR_117", Type::kUnsigned, "", "Maintenance of a Seekur."},
    {119, "SEEKUR_119", Type::kUnsigned, "", "Maintenance of a Seekur."},
    {120, "SEEKUR_120", Type::kUnsigned, "", "Maintenance of a Seekur."},
    {123, "ACCELINFO", Type::kUnsigned, "", "Packets of acceleration: 1 one, more all the time, 0 none."},
    {124, "TORQUEINFO", Type::kUnsigned, "", "Packets of torque: 1 one, more all the time, 0 none."},
    {125, "POWER_125", Type::kUnsigned, "", "Power of a part of the robot."},
    {126, "POWER_126", Type::kUnsigned, "", "Power of a part of the robot."},
    {127, "POWER_127", Type::kUnsigned, "", "Power of a part of the robot."},
    {128, "POWER_128", Type::kUnsigned, "", "Power of a part of the robot."},
    {129, "POWER_129", Type::kUnsigned, "", "Power of a part of the robot."},
    {149, "HEADINGINFO", Type::kUnsigned, "", "Packets of heading: 1 one, more all the time, 0 none."},
    {150, "ROTVEL_CLOSEDLOOP", Type::kUnsigned, "",
     "1: the rate of turning is controlled by what is measured."},
    {210, "SRECORD", Type::kData, "", "Updates the firmware; larger robots."},
    {211, "MARCDEBUG", Type::kData, "", "For those who maintain larger robots."},
    {212, "WHEEL_LIGHT", Type::kData, "", "Lights at the wheels; larger robots."},
    {213, "ABSOLUTE_MAXES", Type::kUnsigned, "",
     "Asks for the speeds and accelerations that can never be exceeded; larger robots."},
    {214, "SAFETY_STATE", Type::kData, "", "Safety system; larger robots."},
    {215, "SAFETY_CONTROL", Type::kData, "", "Safety system; larger robots."},
    {216, "SAFETY_WARNING", Type::kData, "", "Safety system; larger robots."},
    {217, "SAFETY_SPEED", Type::kData, "", "Safety system; larger robots."},
    {218, "WHEELINFO", Type::kUnsigned, "",
     "Packets of the wheels: 1 one, more all the time, 0 none; larger robots."},
    {219, "MARC_CONFIG_READ", Type::kData, "", "Configuration of larger robots."},
    {220, "MARC_CONFIG_WRITE", Type::kData, "", "Configuration of larger robots."},
    {224, "SIM_SET_POSE", Type::kData, "",
     "Simulators: puts the robot at a true pose (mm, mm, deg); its odometry stays."},
    {225, "SIM_RESET", Type::kNone, "", "Simulators: puts the robot back to its start, odometry too."},
    {226, "SIM_MODEL_CONFIG", Type::kData, "", "Simulators: changes the robot's model."},
    {230, "SIM_LRF_ENABLE", Type::kUnsigned, "",
     "Simulators: the laser; 1 plain packets, 2 extended ones, 0 off."},
    {231, "SIM_LRF_SET_FOV_START", Type::kSigned, "deg", "Simulators: the angle at which the laser begins."},
    {232, "SIM_LRF_SET_FOV_END", Type::kSigned, "deg", "Simulators: the angle at which the laser ends."},
    {233, "SIM_LRF_SET_RES", Type::kUnsigned, "0.01 deg", "Simulators: the laser's angle between readings."},
    {236, "SIM_CTRL", Type::kData, "",
     "Simulators: 1 loads a map, 2 loads one for all, 3 forgets that, 4 starts a new log, 5 logs the state, "
     "6 asks what it is, 7 lets the robot pass through things."},
    {237, "SIM_STAT", Type::kUnsigned, "",
     "Simulators: packets with the true pose; 1 one, 2 all the time, 0 none."},
    {238, "SIM_MESSAGE", Type::kString, "", "Simulators: shows a text in the log."},
    {239, "SIM_EXIT", Type::kSigned, "", "Simulators: ends the simulation with this exit status."},
    {250, "BATTEST", Type::kUnsigned, "0.1 V", "Pretends a battery voltage; 0 shows the real one again."},
    {251, "DIGTEMPTEST", Type::kSigned, "", "Pretends a temperature of the digital sensor."},
    {252, "ANTEMPTEST", Type::kSigned, "", "Pretends a temperature of the analog sensor."},
    {253, "RESET", Type::kNone, "", "Restarts the controller."},
    {255, "MAINTENANCE", Type::kNone, "", "Puts the controller into its maintenance mode."},
};

/// For every number its place in kCommands, or -1.
constexpr auto kPlaces = [] {
  std::array<std::int16_t, 256> places{};
  places.fill(-1);
  std::int16_t place = 0;
  for (const CommandInfo& info : kCommands) places[info.id] = place++;
  return places;
}();

}  // namespace

std::span<const CommandInfo> commandTable() {
  return kCommands;
}

const CommandInfo* findCommand(std::uint8_t id) {
  return kPlaces[id] < 0 ? nullptr : &kCommands[kPlaces[id]];
}

const CommandInfo* findCommand(std::string_view name) {
  const auto found = std::find_if(std::begin(kCommands), std::end(kCommands),
                                  [&](const CommandInfo& info) { return info.name == name; });
  return found == std::end(kCommands) ? nullptr : found;
}

std::string nameOf(std::uint8_t commandId) {
  const CommandInfo* info = findCommand(commandId);
  return info ? info->name : "command " + std::to_string(commandId);
}

}  // namespace robotlink::arcos
