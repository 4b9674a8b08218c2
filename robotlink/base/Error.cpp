// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Error.h"

namespace robotlink {

std::string Error::describe() const {
  std::string result;
  if (!where.file.empty()) {
    result = where.file + ":";
    if (where.line > 0) result += std::to_string(where.line) + ":";
    if (where.line > 0 && where.column > 0) result += std::to_string(where.column) + ":";
    result += " ";
  }
  return result + text;
}

std::string describe(const Errors& errors) {
  std::string result;
  for (const Error& error : errors) {
    if (!result.empty()) result += "\n";
    result += error.describe();
  }
  return result;
}

}  // namespace robotlink
