// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace robotlink::arcos {

/// The type of a command's argument; kData is a layout of the command's own.
enum class ArgumentType { kNone, kUnsigned, kSigned, kBytePair, kString, kData };

/// The description of a command for users, as shown by an inspector or a help text.
struct CommandInfo {
  std::uint8_t id = 0;
  ArgumentType argument = ArgumentType::kNone;
  /// The name in the robot's manual: "VEL2".
  const char* name = "";
  /// The unit of an integer argument: "mm/s".
  const char* unit = "";
  /// The effect of the command, in a sentence.
  const char* summary = "";
};

/// All known commands, sorted by id. Static data.
std::span<const CommandInfo> commandCatalog();
/// Null if the command is unknown.
const CommandInfo* findCommand(std::uint8_t id);
/// The command's name: "VEL2", or "command 111" if it is unknown.
std::string nameOf(std::uint8_t commandId);

}  // namespace robotlink::arcos
