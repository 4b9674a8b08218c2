// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/SensorErrors.h"

#include <cmath>

namespace simcore {
namespace {

bool isShare(double value) {
  return value >= 0 && value <= 1;
}

bool isAmount(double value) {
  return value >= 0 && value <= 1e9;
}

}  // namespace

const char* wrongErrors(const SensorErrors& errors) {
  for (const NoiseModel& noise : errors.noise) {
    if (!(std::abs(noise.mean) <= 1e9 && std::abs(noise.biasMean) <= 1e9)) return "a mean must be finite";
    if (!isAmount(noise.stddev) || !isAmount(noise.biasStddev) || !isAmount(noise.driftStddev))
      return "a standard deviation must be 0 or more, and finite";
    if (!isAmount(noise.driftTime)) return "the time constant of a drift must be 0 s or more, and finite";
    if (!isAmount(noise.precision)) return "a precision must be 0 or more, and finite";
  }
  if (!(errors.delay >= 0 && errors.delay <= SensorErrors::kMaxDelay))
    return "a delay must be between 0 and 1 s";
  if (!(errors.rate >= 0 && errors.rate <= 1e6)) return "a rate must be between 0 (each step) and 1e6 Hz";
  if (!isShare(errors.dropout)) return "the probability of a drop-out must be between 0 and 1";
  return "";
}

}  // namespace simcore
