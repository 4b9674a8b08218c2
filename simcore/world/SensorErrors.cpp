// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/SensorErrors.h"

#include <cmath>

#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

constexpr double kMaxAmount = NoiseModel::kForever;
constexpr double kMaxRate = 1e6;  // Hz
/// Sensors whose channels have errors of their own.
constexpr std::size_t kMaxChannels = 1024;

bool isShare(double value) {
  return value >= 0 && value <= 1;
}

bool isAmount(double value) {
  return value >= 0 && value <= kMaxAmount;
}

}  // namespace

void transferNoise(StateStream& stream, std::vector<NoiseModel>& noise) {
  stream.size(noise, kMaxChannels);
  for (NoiseModel& one : noise) {
    for (double* value : {&one.mean, &one.biasMean}) stream.within(*value, -kMaxAmount, kMaxAmount);
    for (double* value : {&one.stddev, &one.biasStddev, &one.driftStddev, &one.driftTime, &one.precision})
      stream.within(*value, 0, kMaxAmount);
  }
}

void transferErrors(StateStream& stream, SensorErrors& errors) {
  transferNoise(stream, errors.noise);
  stream.within(errors.delay, 0, SensorErrors::kMaxDelay);
  stream.within(errors.rate, 0, kMaxRate);
  stream.within(errors.dropout, 0, 1);
}

const char* wrongErrors(const SensorErrors& errors) {
  for (const NoiseModel& noise : errors.noise) {
    if (!(std::abs(noise.mean) <= kMaxAmount && std::abs(noise.biasMean) <= kMaxAmount))
      return "a mean must be finite";
    if (!isAmount(noise.stddev) || !isAmount(noise.biasStddev) || !isAmount(noise.driftStddev))
      return "a standard deviation must be 0 or more, and finite";
    if (!isAmount(noise.driftTime)) return "the time constant of a drift must be 0 s or more, and finite";
    if (!isAmount(noise.precision)) return "a precision must be 0 or more, and finite";
  }
  if (!(errors.delay >= 0 && errors.delay <= SensorErrors::kMaxDelay))
    return "a delay must be between 0 and 1 s";
  if (!(errors.rate >= 0 && errors.rate <= kMaxRate))
    return "a rate must be between 0 (each step) and 1e6 Hz";
  if (!isShare(errors.dropout)) return "the probability of a drop-out must be between 0 and 1";
  return "";
}

}  // namespace simcore
