// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace simcore {

/// Seeds the calling thread's random numbers of ODE.
void seedOdeRandom(std::uint64_t bits);

/// The state of the calling thread's random numbers.
std::uint32_t odeRandomState();
void setOdeRandomState(std::uint32_t state);
/// The state after so many more numbers; costs the logarithm of that.
std::uint32_t odeRandomAfter(std::uint32_t state, std::uint64_t numbers);

/// Follows the random numbers that a thread draws.
class OdeRandomWatch {
 public:
  virtual ~OdeRandomWatch() = default;
  /// Called before ODE draws a number from 0 to `range` - 1, in the drawing thread; may change the state.
  virtual void beforeNumber(int range) = 0;
};
/// Has the calling thread's numbers followed; null: no more.
void watchOdeRandom(OdeRandomWatch* watch);

}  // namespace simcore
