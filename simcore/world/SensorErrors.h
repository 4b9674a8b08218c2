// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace simcore {

/// How the numbers of a sensor differ from the truth, in the unit of its readings: reading = round(truth +
/// mean + white noise + bias + drift). The terms are those of SDFormat's <noise>.
struct NoiseModel {
  /// Mean and standard deviation of the white noise, which is new in each sample.
  double mean = 0, stddev = 0;
  /// Mean and standard deviation of the bias, which is drawn once per run; its sign is random.
  double biasMean = 0, biasStddev = 0;
  /// The drift is a Gauss-Markov process that begins at 0: per second it gains a standard deviation of
  /// driftStddev, and forgets with the time constant driftTime (s). With a time constant of 0 there is none.
  double driftStddev = 0, driftTime = 0;
  /// With this time constant it forgets nothing: a random walk.
  static constexpr double kForever = 1e9;
  /// Readings are multiples of this; 0: they are not rounded.
  double precision = 0;
  bool operator==(const NoiseModel&) const = default;
};

/// All errors of a sensor: of its numbers and of its timing. A plain value; the default changes nothing.
struct SensorErrors {
  /// The noise of all channels, or of each. Empty: there is no noise.
  std::vector<NoiseModel> noise = {};
  /// How long a sample takes until it can be read, s, 0 to kMaxDelay.
  double delay = 0;
  /// Samples per second; 0: in each step of the simulation.
  double rate = 0;
  /// The probability that a sample is lost, 0 to 1. The previous one then remains.
  double dropout = 0;

  static constexpr double kMaxDelay = 1;

  /// The noise of a channel.
  NoiseModel of(std::size_t channel) const {
    if (noise.empty()) return {};
    return noise.size() == 1 ? noise.front() : channel < noise.size() ? noise[channel] : NoiseModel{};
  }
  /// Whether samples are taken, or can be read, otherwise than in each step.
  bool hasTiming() const { return delay > 0 || rate > 0 || dropout > 0; }
  bool operator==(const SensorErrors&) const = default;
};

class StateStream;
/// Writes or reads errors as a part of a simulation's state.
void transferNoise(StateStream& stream, std::vector<NoiseModel>& noise);
void transferErrors(StateStream& stream, SensorErrors& errors);

/// Returns the first problem with errors that a user chose, in words for users; empty if there is none.
const char* wrongErrors(const SensorErrors& errors);

}  // namespace simcore
