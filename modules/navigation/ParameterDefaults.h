// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace modules {

// Parameters come from files and users: a field that is 0, unset or negative stands for the built-in value.

template <typename T>
T orBuiltIn(T value, T builtIn) {
  return value > 0 ? value : builtIn;
}

/// Replaces a built-in value unless the given value is 0 or negative.
template <typename T>
void replace(T& builtIn, T value) {
  builtIn = orBuiltIn(value, builtIn);
}

}  // namespace modules
