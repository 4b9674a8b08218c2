// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace robotlink::arcos {

enum class ArgumentType { kNone, kUnsigned, kSigned, kBytePair, kString, kData };

/// A command for people: what an inspector and a help text show.
struct CommandInfo {
  std::uint8_t id = 0;
  ArgumentType argument = ArgumentType::kNone;
  const char* name = "";     ///< as the robot's manual has it: "VEL2"
  const char* unit = "";     ///< of an integer argument: "mm/s"
  const char* summary = "";  ///< a sentence
};

/// Every command that is known, by number. Lives as long as the program.
std::span<const CommandInfo> commandTable();
/// Null if the number is unknown.
const CommandInfo* findCommand(std::uint8_t id);
const CommandInfo* findCommand(std::string_view name);
/// "VEL2", or "command 111" if the number is unknown.
std::string nameOf(std::uint8_t commandId);

}  // namespace robotlink::arcos
