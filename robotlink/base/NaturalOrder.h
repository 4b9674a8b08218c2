// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace robotlink {

/// Whether a text stands before another one where numbers in them are compared as numbers: "sonar 2" before
/// "sonar 10". Of two that differ in leading zeros only, the one that is first by its characters is first.
bool comesNaturallyBefore(std::string_view a, std::string_view b);

}  // namespace robotlink
