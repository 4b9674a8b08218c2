// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include "robotlink/arcos/codec/CommandId.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// A command from a client to a robot: an id, and optionally an argument.
///
/// An integer is sent as its sign and its magnitude, so it is in -65535 to 65535. A string is any sequence of
/// bytes, including NUL.
struct Command {
  std::uint8_t id = 0;
  std::variant<std::monostate, int, std::string> argument;
  /// Data after the argument (the laser index of SIM_LRF_ENABLE); without an argument, all of the data, as in
  /// commands with a layout of their own (SimulatorCommands.h).
  Bytes extra = {};

  bool operator==(const Command&) const = default;
};

/// The largest magnitude of an integer argument.
inline constexpr int kMaxArgument = 0xFFFF;
/// The longest string that can be sent, without its type, length and final NUL.
inline constexpr std::size_t kMaxSentString = kMaxSentData - 3;

/// Builds a command without an argument, with an integer, or with a string.
inline Command command(CommandId id) {
  return {static_cast<std::uint8_t>(id), {}};
}
inline Command command(CommandId id, int argument) {
  return {static_cast<std::uint8_t>(id), argument};
}
inline Command command(CommandId id, std::string argument) {
  return {static_cast<std::uint8_t>(id), std::move(argument)};
}

/// The integer argument; if there is none, `without`, the value that the robot assumes (for CONFIG and OPEN
/// 1).
int integerArgument(const Command& command, int without = 0);
/// The string argument; empty if there is none.
std::string stringArgument(const Command& command);

/// The two bytes that VEL2, DIGOUT, TIMER and PTUPOS pass in one integer argument.
struct BytePair {
  /// For VEL2 the left wheels.
  std::int8_t high = 0;
  /// For VEL2 the right wheels.
  std::int8_t low = 0;
  bool operator==(const BytePair&) const = default;
};
/// Packs the bytes into an integer argument; split() is the inverse.
int joined(BytePair pair);
BytePair split(int argument);

/// Checks that integer and string fit, so that the command can be sent unchanged. The error says what to do.
Result<void> check(const Command& command);

/// Encodes a command. An integer beyond kMaxArgument is clamped, a string or extra data too long for a
/// frame are truncated; use check() to detect that.
Packet toPacket(const Command& command);

/// Decodes any packet from a client. Missing bytes of an integer count as 0; strings are accepted with or
/// without length and final NUL. Fails only for a string that is too long to be sent again.
Result<Command> toCommand(const Packet& packet);

}  // namespace robotlink::arcos
