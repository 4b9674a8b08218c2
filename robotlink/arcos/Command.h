// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include "robotlink/arcos/Packet.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// The numbers of the commands that programs name; commandTable() knows more. 0 to 2 are the handshake's SYNC
/// before a robot is connected.
enum class CommandId : std::uint8_t {
  kPulse = 0,
  kOpen = 1,
  kClose = 2,
  kSync0 = 0,
  kSync1 = 1,
  kSync2 = 2,
  kPolling = 3,
  kEnable = 4,
  kSetA = 5,
  kSetV = 6,
  kSetO = 7,
  kMove = 8,
  kRotate = 9,
  kSetRv = 10,
  kVel = 11,
  kHead = 12,
  kDhead = 13,
  kRotationLimit = 14,
  kSay = 15,
  kJoyRequest = 17,
  kConfig = 18,
  kEncoder = 19,
  kSetRvDir = 20,
  kRvel = 21,
  kDchead = 22,
  kSetRa = 23,
  kImuRequest = 26,
  kSonar = 28,
  kStop = 29,
  kDigOut = 30,
  kTimer = 31,
  kVel2 = 32,
  kGripper = 33,
  kAdSel = 35,
  kGripperValue = 36,
  kGripperRequest = 37,
  kLegacyLaserEnable = 35,  ///< simulators: 35 to 38 control the laser as 230 to 233 do
  kLegacyLaserStart = 36,
  kLegacyLaserEnd = 37,
  kLegacyLaserResolution = 38,
  kIoRequest = 40,
  kPtuPos = 41,
  kTty2 = 42,
  kGetAux = 43,
  kBumpStall = 44,
  kTcm2 = 45,
  kJoyDrive = 47,
  kSonarCycle = 48,
  kHostBaud = 50,
  kEStop = 55,
  kMStall = 56,
  kQStop = 57,
  kGyro = 58,
  kLcdWrite = 59,
  kTty4 = 60,
  kGetAux3 = 61,
  kBatteryInfo = 62,
  kTty3 = 66,
  kGetAux2 = 67,
  kRotKp = 82,
  kRotKv = 83,
  kRotKi = 84,
  kTransKp = 85,
  kTransKv = 86,
  kTransKi = 87,
  kRevCount = 88,
  kDriftFactor = 89,
  kSoundTog = 92,
  kTicksMm = 93,
  kLatVel = 110,
  kLatAccel = 113,
  kSimSetPose = 224,
  kSimReset = 225,
  kSimModelConfig = 226,
  kSimLaserEnable = 230,
  kSimLaserStart = 231,
  kSimLaserEnd = 232,
  kSimLaserResolution = 233,
  kSimControl = 236,
  kSimStat = 237,
  kSimMessage = 238,
  kSimExit = 239,
  kBatTest = 250,
  kReset = 253,
  kMaintenance = 255,
};

/// What a client tells a robot: a number, and an argument or none.
///
/// An integer goes as its sign and its magnitude, so it may be -65535 to 65535. A string is bytes, NULs
/// included.
struct Command {
  std::uint8_t id = 0;
  std::variant<std::monostate, int, std::string> argument;
  /// What stands behind the argument (SIM_LRF_ENABLE's laser index); without argument, all of the data, as of
  /// commands with a form of their own (SimulatorCommands.h).
  Bytes extra = {};

  bool operator==(const Command&) const = default;
};

inline constexpr int kMaximumArgument = 0xFFFF;
inline constexpr std::size_t kMaximumSentString = kMaximumSentData - 3;

inline Command command(CommandId id) {
  return {static_cast<std::uint8_t>(id), {}};
}
inline Command command(CommandId id, int argument) {
  return {static_cast<std::uint8_t>(id), argument};
}
inline Command command(CommandId id, std::string argument) {
  return {static_cast<std::uint8_t>(id), std::move(argument)};
}

/// The integer argument; without one 0, or what a request means without one (CONFIG, OPEN: 1).
int integerArgument(const Command& command, int without = 0);
/// The string argument, empty if there is none.
std::string stringArgument(const Command& command);

/// The arguments of VEL2, DIGOUT, TIMER and PTUPOS are two bytes in one integer.
struct BytePair {
  std::int8_t high = 0;  ///< VEL2: left
  std::int8_t low = 0;   ///< VEL2: right
  bool operator==(const BytePair&) const = default;
};
int joined(BytePair pair);
BytePair split(int argument);

/// Whether the command can be sent as it is: integer and string fit. The error says what to do.
Result<void> check(const Command& command);

/// An integer past kMaximumArgument becomes the nearest that fits, a string or extra that no frame holds is
/// cut: see check().
Packet toPacket(const Command& command);

/// Any packet from a client. Integers that are cut short count as 0 where bytes are missing; strings may come
/// with or without length and final NUL. Fails only where a string is longer than one that can be sent back.
Result<Command> toCommand(const Packet& packet);

}  // namespace robotlink::arcos
