// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotlink {

/// The text with every byte that is not part of well-formed UTF-8 replaced by '?': strings of packages must
/// be UTF-8, or who receives the package cannot read any of it.
std::string validUtf8(std::string text);

}  // namespace robotlink
