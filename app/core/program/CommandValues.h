// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "robotlink/session/CommandTable.h"

namespace app {

/// The arguments of a command, as many and of such types as its entry in the table says. The functions below
/// return one of them.
using Values = std::vector<robotlink::CommandTable::Value>;

inline const std::string& text(const Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}
inline double number(const Values& values, std::size_t index) {
  return std::get<double>(values[index]);
}
inline bool flag(const Values& values, std::size_t index) {
  return std::get<bool>(values[index]);
}

}  // namespace app
