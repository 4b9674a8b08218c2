// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/ArcosCommandCatalog.h"

#include <algorithm>
#include <array>

namespace robotlink::arcos {
namespace {

using Type = ArgumentType;

constexpr CommandInfo kCommands[] = {
    {0, Type::kNone, "PULSE", "", "Signals that the client is alive; SYNC0 before a connection."},
    {1, Type::kUnsigned, "OPEN", "",
     "Starts the robot's servers and its information packets; SYNC1 before a connection."},
    {2, Type::kUnsigned, "CLOSE", "",
     "Stops motors and information packets and ends the connection; SYNC2 before a connection."},
    {3, Type::kString, "POLLING", "",
     "Sonar firing sequence: one byte a sonar, from 1; empty turns all off."},
    {4, Type::kUnsigned, "ENABLE", "", "1 turns the motors on, 0 off."},
    {5, Type::kSigned, "SETA", "mm/s2", "Acceleration, or deceleration if negative."},
    {6, Type::kUnsigned, "SETV", "mm/s", "Maximum speed, and that of MOVE."},
    {7, Type::kNone, "SETO", "", "The place where the robot is becomes its odometry's origin."},
    {8, Type::kSigned, "MOVE", "mm", "Drives so far at the maximum speed, backward if negative."},
    {9, Type::kSigned, "ROTATE", "deg/s", "Turns at that rate, counter-clockwise if positive."},
    {10, Type::kUnsigned, "SETRV", "deg/s", "Maximum rate of turning, and that of HEAD and DHEAD."},
    {11, Type::kSigned, "VEL", "mm/s", "Drives at that speed, backward if negative."},
    {12, Type::kSigned, "HEAD", "deg", "Turns to that heading of its odometry."},
    {13, Type::kSigned, "DHEAD", "deg",
     "Turns by that much from its heading, counter-clockwise if positive."},
    {14, Type::kSigned, "DROTATE", "deg/s",
     "Limits turning to one direction: counter-clockwise if positive; 0 removes the limit, 1 and -1 block."},
    {15, Type::kString, "SAY", "", "Plays tones: pairs of duration (20 ms) and tone."},
    {17, Type::kUnsigned, "JOYREQUEST", "", "Joystick packets: 1 one, more all the time, 0 none."},
    {18, Type::kUnsigned, "CONFIG", "", "Asks for the configuration."},
    {19, Type::kUnsigned, "ENCODER", "", "Encoder packets: 1 one, more all the time, 0 none."},
    {20, Type::kSigned, "SETRVDIR", "deg/s",
     "Maximum rate of turning in one direction: counter-clockwise if positive."},
    {21, Type::kSigned, "RVEL", "deg/s", "Turns at that rate, counter-clockwise if positive."},
    {22, Type::kSigned, "DCHEAD", "deg", "Turns by that much from the last heading that was asked for."},
    {23, Type::kSigned, "SETRA", "deg/s2", "Acceleration of turning, or deceleration if negative."},
    {24, Type::kUnsigned, "GYRORANGE", "", "Range of the gyroscope."},
    {25, Type::kUnsigned, "GYRORATELIMIT", "0.1 deg/s", "Rate past which the gyroscope is not trusted."},
    {26, Type::kUnsigned, "IMUREQUEST", "",
     "Inertial measurements: 1 one packet, more all the time, 0 none."},
    {27, Type::kBytePair, "IMUWRITE", "", "Writes a register of the inertial measurement unit."},
    {28, Type::kUnsigned, "SONAR", "",
     "1 turns all sonars on, 0 off; else bit 0 says on or off and bits 1 to 4 which array."},
    {29, Type::kNone, "STOP", "", "Brakes to a stop; the motors stay on."},
    {30, Type::kBytePair, "DIGOUT", "", "Digital outputs: high byte which to change, low byte their values."},
    {31, Type::kBytePair, "TIMER", "",
     "Power of what is attached to ports: high byte which, low byte the values."},
    {32, Type::kBytePair, "VEL2", "20 mm/s", "Speeds of the wheels: high byte left, low byte right."},
    {33, Type::kUnsigned, "GRIPPER", "",
     "1 open, 2 close, 3 stop, 4 lift up, 5 lift down, 6 lift stop, 7 store, 8 deploy, 15 halt."},
    {34, Type::kUnsigned, "KICK", "ms", "A pulse on digital output 0."},
    {35, Type::kUnsigned, "ADSEL", "",
     "Which analog port information packets show; simulators: the laser, 1 plain, 2 extended, 0 off."},
    {36, Type::kSigned, "GRIPPERVAL", "",
     "Value of the gripper's last command; simulators: the angle (deg) at which the laser begins."},
    {37, Type::kSigned, "GRIPREQUEST", "",
     "Gripper packets: 1 one, more all the time, 0 none; simulators: the angle (deg) at which the laser "
     "ends."},
    {38, Type::kUnsigned, "GYROCALCW", "",
     "Calibration of the gyroscope clockwise; simulators: the laser's angle (0.01 deg) between readings."},
    {39, Type::kUnsigned, "GYROCALCCW", "", "Calibration of the gyroscope counter-clockwise."},
    {40, Type::kUnsigned, "IOREQUEST", "", "Input and output packets: 1 one, more all the time, 0 none."},
    {41, Type::kBytePair, "PTUPOS", "", "Servo pulse: high byte the port, low byte its width (0.1 ms)."},
    {42, Type::kString, "TTY2", "", "Sends to serial port AUX1."},
    {43, Type::kUnsigned, "GETAUX", "bytes",
     "How many bytes from AUX1 to send as a packet; 0 forgets what came."},
    {44, Type::kUnsigned, "BUMPSTALL", "", "Which bumpers count as stall: 0 none, 1 front, 2 rear, 3 both."},
    {45, Type::kUnsigned, "TCM2", "",
     "Compass: 0 off, 1 in information packets, 2 one packet, 3 all the time, 4 to 7 calibration."},
    {46, Type::kUnsigned, "JOYINFO", "", "Joystick packets of older robots."},
    {47, Type::kUnsigned, "JOYDRIVE", "",
     "1 lets the joystick drive while a client is connected, 0 does not."},
    {48, Type::kUnsigned, "SONARCYCLE", "ms", "Time between two sonars of an array, 2 to 120."},
    {49, Type::kUnsigned, "MOVINGBLINK", "", "1 blinks while moving."},
    {50, Type::kUnsigned, "HOSTBAUD", "",
     "Rate of the line to the client: 0 is 9600, 1 19200, 2 38400, 3 57600, 4 115200."},
    {51, Type::kUnsigned, "AUX1BAUD", "", "Rate of AUX1, as HOSTBAUD."},
    {52, Type::kUnsigned, "AUX2BAUD", "", "Rate of AUX2, as HOSTBAUD."},
    {53, Type::kUnsigned, "AUX3BAUD", "", "Rate of AUX3, as HOSTBAUD."},
    {54, Type::kUnsigned, "LOWBATTERY", "0.1 V", "Voltage at which the battery counts as low."},
    {55, Type::kNone, "E_STOP", "", "Stops at once, whatever the deceleration."},
    {56, Type::kUnsigned, "M_STALL", "", "1: the motors' button causes a stall."},
    {57, Type::kNone, "QSTOP", "", "Stops at once; simulators."},
    {58, Type::kUnsigned, "GYRO", "",
     "Gyroscope packets: 1 one, more all the time, 0 none; a gyroscope that the robot uses itself: 1 on, 0 "
     "off."},
    {59, Type::kString, "LCDWRITE", "", "Writes to the display: column, row, whether to clear, text."},
    {60, Type::kString, "TTY4", "", "Sends to serial port AUX3."},
    {61, Type::kUnsigned, "GETAUX3", "bytes",
     "How many bytes from AUX3 to send as a packet; 0 forgets what came."},
    {62, Type::kUnsigned, "BATTERYINFO", "", "Battery packets: 1 one, 2 all the time, 0 none."},
    {65, Type::kUnsigned, "CALCOMP", "", "Calibration of the compass."},
    {66, Type::kString, "TTY3", "", "Sends to serial port AUX2."},
    {67, Type::kUnsigned, "GETAUX2", "bytes",
     "How many bytes from AUX2 to send as a packet; 0 forgets what came."},
    {68, Type::kUnsigned, "CHARGE", "", "1 deploys the docking mechanism, 0 releases it."},
    {70, Type::kUnsigned, "ARM_INFO", "", "Arm: asks for its description."},
    {71, Type::kUnsigned, "ARM_STATUS", "", "Arm: packets of its state; 1 one, more all the time, 0 none."},
    {72, Type::kNone, "ARM_INIT", "", "Arm: initializes it."},
    {73, Type::kNone, "ARM_CHECK", "", "Arm: checks it."},
    {74, Type::kUnsigned, "ARM_POWER", "", "Arm: power on (1) or off (0)."},
    {75, Type::kUnsigned, "ARM_HOME", "", "Arm: moves joints home."},
    {76, Type::kNone, "ARM_PARK", "", "Arm: parks it."},
    {77, Type::kBytePair, "ARM_POS", "",
     "Arm: a joint's position; high byte the joint, low byte the position."},
    {78, Type::kBytePair, "ARM_SPEED", "", "Arm: a joint's speed."},
    {79, Type::kUnsigned, "ARM_STOP", "", "Arm: stops joints."},
    {80, Type::kUnsigned, "ARM_AUTOPARK", "s", "Arm: parks after this time without a command."},
    {81, Type::kUnsigned, "ARM_GRIPPARK", "s", "Arm: parks its gripper after this time without a command."},
    {82, Type::kUnsigned, "ROTKP", "", "Proportional gain of turning."},
    {83, Type::kUnsigned, "ROTKV", "", "Differential gain of turning."},
    {84, Type::kUnsigned, "ROTKI", "", "Integral gain of turning."},
    {85, Type::kUnsigned, "TRANSKP", "", "Proportional gain of driving."},
    {86, Type::kUnsigned, "TRANSKV", "", "Differential gain of driving."},
    {87, Type::kUnsigned, "TRANSKI", "", "Integral gain of driving."},
    {88, Type::kUnsigned, "REVCOUNT", "ticks", "Encoder ticks of a turn by half a circle, over 4."},
    {89, Type::kSigned, "DRIFTFACTOR", "1/8192", "Difference of the sizes of left and right wheels."},
    {90, Type::kUnsigned, "SOUND", "", "Plays a stored sound."},
    {91, Type::kUnsigned, "PLAYLIST", "", "Asks for the list of sounds."},
    {92, Type::kUnsigned, "SOUNDTOG", "", "1 turns sounds on, 0 off."},
    {93, Type::kUnsigned, "TICKSMM", "ticks/mm", "Encoder ticks of a millimeter."},
    {95, Type::kUnsigned, "POWER_PC", "", "Power of the computer."},
    {96, Type::kUnsigned, "POWER_LRF", "", "Power of the laser."},
    {97, Type::kUnsigned, "POWER_5V", "", "Power of the 5 V supply."},
    {98, Type::kUnsigned, "POWER_12V", "", "Power of the 12 V supply."},
    {102, Type::kUnsigned, "FREESPACE", "", "Display of the space that is free."},
    {110, Type::kSigned, "LATVEL", "mm/s", "Drives sideways; robots that can."},
    {113, Type::kSigned, "LATACCEL", "mm/s2", "Acceleration sideways, or deceleration if negative."},
    {117, Type::kUnsigned, "SEEKUR_117", "", "Maintenance of a Seekur."},
    {119, Type::kUnsigned, "SEEKUR_119", "", "Maintenance of a Seekur."},
    {120, Type::kUnsigned, "SEEKUR_120", "", "Maintenance of a Seekur."},
    {123, Type::kUnsigned, "ACCELINFO", "", "Packets of acceleration: 1 one, more all the time, 0 none."},
    {124, Type::kUnsigned, "TORQUEINFO", "", "Packets of torque: 1 one, more all the time, 0 none."},
    {125, Type::kUnsigned, "POWER_125", "", "Power of a part of the robot."},
    {126, Type::kUnsigned, "POWER_126", "", "Power of a part of the robot."},
    {127, Type::kUnsigned, "POWER_127", "", "Power of a part of the robot."},
    {128, Type::kUnsigned, "POWER_128", "", "Power of a part of the robot."},
    {129, Type::kUnsigned, "POWER_129", "", "Power of a part of the robot."},
    {149, Type::kUnsigned, "HEADINGINFO", "", "Packets of heading: 1 one, more all the time, 0 none."},
    {150, Type::kUnsigned, "ROTVEL_CLOSEDLOOP", "",
     "1: the rate of turning is controlled by what is measured."},
    {210, Type::kData, "SRECORD", "", "Updates the firmware; larger robots."},
    {211, Type::kData, "MARCDEBUG", "", "Maintenance of larger robots."},
    {212, Type::kData, "WHEEL_LIGHT", "", "Lights at the wheels; larger robots."},
    {213, Type::kUnsigned, "ABSOLUTE_MAXES", "",
     "Asks for the speeds and accelerations that can never be exceeded; larger robots."},
    {214, Type::kData, "SAFETY_STATE", "", "Safety system; larger robots."},
    {215, Type::kData, "SAFETY_CONTROL", "", "Safety system; larger robots."},
    {216, Type::kData, "SAFETY_WARNING", "", "Safety system; larger robots."},
    {217, Type::kData, "SAFETY_SPEED", "", "Safety system; larger robots."},
    {218, Type::kUnsigned, "WHEELINFO", "",
     "Packets of the wheels: 1 one, more all the time, 0 none; larger robots."},
    {219, Type::kData, "MARC_CONFIG_READ", "", "Configuration of larger robots."},
    {220, Type::kData, "MARC_CONFIG_WRITE", "", "Configuration of larger robots."},
    {224, Type::kData, "SIM_SET_POSE", "",
     "Simulators: puts the robot at a true pose (mm, mm, deg); its odometry stays."},
    {225, Type::kNone, "SIM_RESET", "", "Simulators: puts the robot back to its start, odometry too."},
    {226, Type::kData, "SIM_MODEL_CONFIG", "", "Simulators: changes the robot's model."},
    {230, Type::kUnsigned, "SIM_LRF_ENABLE", "",
     "Simulators: the laser; 1 plain packets, 2 extended ones, 0 off."},
    {231, Type::kSigned, "SIM_LRF_SET_FOV_START", "deg", "Simulators: the angle at which the laser begins."},
    {232, Type::kSigned, "SIM_LRF_SET_FOV_END", "deg", "Simulators: the angle at which the laser ends."},
    {233, Type::kUnsigned, "SIM_LRF_SET_RES", "0.01 deg", "Simulators: the laser's angle between readings."},
    {236, Type::kData, "SIM_CTRL", "",
     "Simulators: 1 loads a map, 2 loads one for all, 3 forgets that, 4 starts a new log, 5 logs the state, "
     "6 asks what it is, 7 lets the robot pass through things."},
    {237, Type::kUnsigned, "SIM_STAT", "",
     "Simulators: packets with the true pose; 1 one, 2 all the time, 0 none."},
    {238, Type::kString, "SIM_MESSAGE", "", "Simulators: shows a text in the log."},
    {239, Type::kSigned, "SIM_EXIT", "", "Simulators: ends the simulation with this exit status."},
    {250, Type::kUnsigned, "BATTEST", "0.1 V", "Pretends a battery voltage; 0 shows the real one again."},
    {251, Type::kSigned, "DIGTEMPTEST", "", "Pretends a temperature of the digital sensor."},
    {252, Type::kSigned, "ANTEMPTEST", "", "Pretends a temperature of the analog sensor."},
    {253, Type::kNone, "RESET", "", "Restarts the controller."},
    {255, Type::kNone, "MAINTENANCE", "", "Puts the controller into its maintenance mode."},
};

/// The index in kCommands for every id, or -1.
constexpr auto kPlaces = [] {
  std::array<std::int16_t, 256> places{};
  places.fill(-1);
  std::int16_t place = 0;
  for (const CommandInfo& info : kCommands) places[info.id] = place++;
  return places;
}();

}  // namespace

std::span<const CommandInfo> commandCatalog() {
  return kCommands;
}

const CommandInfo* findCommand(std::uint8_t id) {
  return kPlaces[id] < 0 ? nullptr : &kCommands[kPlaces[id]];
}

std::string nameOf(std::uint8_t commandId) {
  const CommandInfo* info = findCommand(commandId);
  return info ? info->name : "command " + std::to_string(commandId);
}

}  // namespace robotlink::arcos
