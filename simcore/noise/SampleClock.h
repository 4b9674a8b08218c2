// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "simcore/world/SensorErrors.h"

namespace simcore {

/// Says in which steps of the simulation a sensor takes its samples, and when they can be read. Everything is
/// a function of (seed, stream, step), so it does not matter how often it is asked. A plain value.
class SampleClock {
 public:
  /// `stream` separates the drop-outs of sensors; `step` is the duration of a step, s.
  SampleClock(const SensorErrors& errors, std::uint64_t stream, double step);

  /// The number of the sample that is taken in a step, if there is one and it is not lost.
  std::optional<std::uint64_t> sampleAt(std::uint64_t seed, std::uint64_t step) const;
  /// The step of the newest sample that can be read in a step, not before step `oldest`, which represents
  /// everything before it.
  std::uint64_t readable(std::uint64_t seed, std::uint64_t step, std::uint64_t oldest) const;
  /// Steps between a sample and its being readable.
  std::uint64_t delay() const { return delay_; }

 private:
  std::uint64_t stream_ = 0;
  /// Steps per sample, at least 1.
  double period_ = 1;
  std::uint64_t delay_ = 0;
  double dropout_ = 0;
};

}  // namespace simcore
