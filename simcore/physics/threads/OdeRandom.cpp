// SPDX-License-Identifier: GPL-3.0-or-later
// ODE shuffles its constraints with random numbers from one seed for the whole program, so simulations in
// several threads would disturb each other. The functions here replace those of its shared library (the
// dynamic linker prefers the program's own definitions), with one seed per thread, which is set before each
// step and each island.
#include "simcore/physics/threads/OdeRandom.h"

#include <ode/ode.h>

namespace {

// The generator of ODE's misc.cpp, a linear congruential one (Knuth, volume 2, section 3.3.4, table 1, line
// 15).
constexpr std::uint32_t kFactor = 1664525U, kSummand = 1013904223U;

/// Drawn from some thousand times a step: found without a call.
[[gnu::tls_model("initial-exec")]] thread_local std::uint32_t threadSeed = 0;

}  // namespace

namespace simcore {

void seedOdeRandom(std::uint64_t bits) {
  threadSeed = static_cast<std::uint32_t>(bits ^ (bits >> 32));
}

}  // namespace simcore

extern "C" {

unsigned long dRand(void) {
  threadSeed = kFactor * threadSeed + kSummand;
  return threadSeed;
}

unsigned long dRandGetSeed(void) {
  return threadSeed;
}

void dRandSetSeed(unsigned long seed) {
  threadSeed = static_cast<std::uint32_t>(seed);
}

int dRandInt(int n) {
  // The high bits of such a generator are the more random ones.
  return n <= 0
             ? 0
             : static_cast<int>((static_cast<std::uint64_t>(dRand()) * static_cast<std::uint64_t>(n)) >> 32);
}

}  // extern "C"
