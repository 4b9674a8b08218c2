// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "robotlink/commands/CommandTable.h"

namespace app {

/// The arguments of a command. The command table has checked their number and types against the command's
/// entry, so the functions below, each of which returns one argument, do not check them again.
using Values = robotlink::CommandTable::Values;

/// The argument must be of type kText.
inline const std::string& text(const Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}
/// The argument must be of type kNumber.
inline double number(const Values& values, std::size_t index) {
  return std::get<double>(values[index]);
}
/// The argument must be of type kBool.
inline bool flag(const Values& values, std::size_t index) {
  return std::get<bool>(values[index]);
}

}  // namespace app
