// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "simcore/world/SensorErrors.h"

namespace simcore {

class StateStream;

/// Selects the random numbers of a reading.
struct NoiseSelection {
  /// Whether the noise of the scene is added; noise that a user chose always is.
  bool on = true;
  std::uint64_t seed = 0;
  std::uint64_t step = 0;
};

/// Adds noise, bias, drift and rounding to the readings of one sensor.
///
/// All random numbers come from counters: the errors of a sample depend on the seed, the stream and the step
/// in which it is taken, and on nothing else; neither on other sensors nor on how often it is read. The drift
/// is the sum over all steps before; it is continued from the last sample, which costs some 25 ns per channel
/// and step. One thread at a time.
class NoiseProcess {
 public:
  /// Identifies the random numbers of a sensor: no two sensors have the same (domain, index).
  struct Stream {
    std::uint64_t domain = 0, index = 0;
  };
  /// `biases`: how many channels have a bias and a drift of their own; the others share the last one.
  NoiseProcess(Stream stream, std::size_t biases, double step, std::vector<NoiseModel> noise);

  /// Replaces the noise from this step on. The drift so far stays, unless there is no noise any longer.
  void change(std::vector<NoiseModel> noise, std::uint64_t seed, std::uint64_t step);
  /// Writes or reads all on which later samples depend. `step` is the present one of the simulation.
  void transfer(StateStream& stream, std::uint64_t seed, std::uint64_t step);
  /// Whether there is anything to be added.
  bool any() const { return any_; }
  /// Adds the errors of the sample that is taken in `step` to all elements for which `counts(value)`.
  template <typename Counts>
  void apply(std::uint64_t seed, std::uint64_t step, double* values, std::size_t count, Counts counts) {
    if (!any_) return;
    begin(seed, step);
    for (std::size_t i = 0; i < count; ++i) {
      const double white = normal();
      if (counts(values[i])) values[i] = erroneous(i, values[i], white);
    }
  }
  void apply(std::uint64_t seed, std::uint64_t step, std::vector<double>& values) {
    apply(seed, step, values.data(), values.size(), [](double) { return true; });
  }

 private:
  /// Selects the random numbers of a sample, and continues the drift up to it.
  void begin(std::uint64_t seed, std::uint64_t step);
  void continueDrift(std::uint64_t seed, std::uint64_t step);
  /// The next normally distributed number of the sample; 0 if there is no white noise.
  double normal();
  double erroneous(std::size_t channel, double value, double white) const;
  const NoiseModel& of(std::size_t channel) const {
    // The drift so far stays when the noise is removed.
    static constexpr NoiseModel kNone{};
    if (noise_.empty()) return kNone;
    return noise_[channel < noise_.size() ? channel : noise_.size() - 1];
  }
  void examine();

  Stream stream_;
  double step_;
  std::vector<NoiseModel> noise_;
  bool any_ = false, white_ = false, biased_ = false, drifts_ = false;
  /// Seed and counter of the white noise.
  std::uint64_t whiteStream_ = 0, whiteSeed_ = 0, drawn_ = 0;
  /// For each channel with a bias of its own; for which seed and step they are valid.
  std::vector<double> biases_, drift_;
  std::uint64_t biasSeed_ = 0, driftSeed_ = 0, driftStep_ = 0;
  bool biasesDrawn_ = false;
};

}  // namespace simcore
