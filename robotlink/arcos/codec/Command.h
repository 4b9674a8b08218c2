// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include "robotlink/arcos/codec/CommandId.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

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
