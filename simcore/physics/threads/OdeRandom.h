// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace simcore {

/// Seeds the calling thread's random numbers of ODE.
void seedOdeRandom(std::uint64_t bits);

}  // namespace simcore
