// SPDX-License-Identifier: GPL-3.0-or-later
// ODE shuffles its constraints with random numbers from one seed for the whole program, so simulations in
// several threads would disturb each other. The functions here replace those of its shared library (the
// dynamic linker prefers the program's own definitions), with one seed per thread, which Physics sets before
// each step.
#include "simcore/physics/threads/OdeRandom.h"

#include <ode/ode.h>

namespace {

// The generator of ODE's misc.cpp, a linear congruential one (Knuth, volume 2, section 3.3.4, table 1, line
// 15).
constexpr std::uint32_t kFactor = 1664525U, kSummand = 1013904223U;

thread_local std::uint32_t threadSeed = 0;
thread_local simcore::OdeRandomWatch* threadWatch = nullptr;

}  // namespace

namespace simcore {

void seedOdeRandom(std::uint64_t bits) {
  threadSeed = static_cast<std::uint32_t>(bits ^ (bits >> 32));
}

std::uint32_t odeRandomState() {
  return threadSeed;
}

void setOdeRandomState(std::uint32_t state) {
  threadSeed = state;
}

std::uint32_t odeRandomAfter(std::uint32_t state, std::uint64_t numbers) {
  // n steps are one step with another factor and summand; those of twice as many follow by squaring.
  std::uint32_t factor = kFactor, summand = kSummand;
  for (; numbers > 0; numbers >>= 1U) {
    if ((numbers & 1U) != 0) state = factor * state + summand;
    summand *= factor + 1;
    factor *= factor;
  }
  return state;
}

void watchOdeRandom(OdeRandomWatch* watch) {
  threadWatch = watch;
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
  if (threadWatch != nullptr) threadWatch->beforeNumber(n);
  // The high bits of such a generator are the more random ones.
  return n <= 0
             ? 0
             : static_cast<int>((static_cast<std::uint64_t>(dRand()) * static_cast<std::uint64_t>(n)) >> 32);
}

}  // extern "C"
