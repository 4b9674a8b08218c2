// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotlink {

/// Returns the text with every byte that is not part of well-formed UTF-8 replaced by '?'. Strings of
/// packages must be UTF-8; otherwise receivers cannot parse the package at all.
std::string validUtf8(std::string text);

}  // namespace robotlink
