// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace simcore {

/// Seeds ODE's random numbers for the calling thread.
void seedOdeRandom(std::uint64_t bits);

}  // namespace simcore
