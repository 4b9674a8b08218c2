// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/noise/NoiseProcess.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "robotlink/base/Random.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// A sample is at most this many steps old when it is taken.
constexpr std::uint64_t kMaxSampleAge = 400;

/// Separate biases and drifts from white noise.
constexpr std::uint64_t kBiasStream = 0x62696173, kDriftStream = 0x6472696674;

}  // namespace

NoiseProcess::NoiseProcess(Stream stream, std::size_t biases, double step, std::vector<NoiseModel> noise)
    : stream_(stream), step_(step), noise_(std::move(noise)), biases_(biases), drift_(biases) {
  examine();
}

void NoiseProcess::examine() {
  const auto has = [&](double NoiseModel::*amount) {
    return std::ranges::any_of(noise_, [&](const NoiseModel& noise) { return noise.*amount != 0; });
  };
  white_ = has(&NoiseModel::stddev);
  biased_ = has(&NoiseModel::biasMean) || has(&NoiseModel::biasStddev);
  drifts_ = has(&NoiseModel::driftStddev) && has(&NoiseModel::driftTime);
  const bool drifted = std::ranges::any_of(drift_, [](double drift) { return drift != 0; });
  any_ = white_ || biased_ || drifts_ || drifted || has(&NoiseModel::mean) || has(&NoiseModel::precision);
  biasesDrawn_ = false;
}

void NoiseProcess::change(std::vector<NoiseModel> noise, std::uint64_t seed, std::uint64_t step) {
  continueDrift(seed, step);
  noise_ = std::move(noise);
  if (noise_.empty()) std::ranges::fill(drift_, 0.0);
  examine();
}

void NoiseProcess::transfer(StateStream& stream, std::uint64_t seed, std::uint64_t step) {
  // If the sensor was not read for long, the drift catches up before it is saved, so that loading need not do
  // it.
  const bool isOther = driftSeed_ != seed || driftStep_ > step;
  if (!stream.isReading() && (isOther || step > driftStep_ + kMaxSampleAge))
    continueDrift(seed, step > kMaxSampleAge ? step - kMaxSampleAge : 0);
  transferNoise(stream, noise_);
  for (double& drift : drift_) stream.number(drift);
  stream.raw(driftSeed_);
  stream.upTo(driftStep_, step);
  if (!stream.isReading()) return;
  examine();
  stream.require(driftSeed_ == seed);
  stream.require(step <= driftStep_ + kMaxSampleAge);
}

void NoiseProcess::begin(std::uint64_t seed, std::uint64_t step) {
  whiteSeed_ = robotlink::hashBits(seed, robotlink::hashBits(stream_.domain, stream_.index, step), 0);
  drawn_ = 0;
  if (biased_ && (!biasesDrawn_ || biasSeed_ != seed)) {
    for (std::size_t i = 0; i < biases_.size(); ++i) {
      robotlink::Random random(seed, robotlink::hashBits(kBiasStream ^ stream_.domain, stream_.index,
                                                         static_cast<std::uint64_t>(i)));
      const double amount = of(i).biasMean + of(i).biasStddev * random.normal();
      biases_[i] = random.uniform() < 0.5 ? -amount : amount;
    }
    biasSeed_ = seed;
    biasesDrawn_ = true;
  }
  continueDrift(seed, step);
}

void NoiseProcess::continueDrift(std::uint64_t seed, std::uint64_t step) {
  if (seed != driftSeed_ || step < driftStep_) {
    std::ranges::fill(drift_, 0.0);
    driftStep_ = 0;
    driftSeed_ = seed;
  }
  for (; drifts_ && driftStep_ < step; ++driftStep_) {
    for (std::size_t i = 0; i < drift_.size(); ++i) {
      const NoiseModel& noise = of(i);
      if (noise.driftTime <= 0) continue;
      robotlink::Random random(
          seed, robotlink::hashBits(robotlink::hashBits(kDriftStream, stream_.domain, stream_.index),
                                    static_cast<std::uint64_t>(i), driftStep_ + 1));
      // The exact discretization of the process, as in Gazebo's GaussianNoiseModel.
      const double tau = noise.driftTime;
      const double gained = noise.driftStddev * std::sqrt(-tau / 2 * std::expm1(-2 * step_ / tau));
      drift_[i] = std::exp(-step_ / tau) * drift_[i] + gained * random.normal();
    }
  }
  driftStep_ = step;
}

double NoiseProcess::normal() {
  if (!white_) return 0;
  // The same numbers as those of a robotlink::Random.
  const auto uniform = [&] {
    return static_cast<double>(robotlink::mixBits(whiteSeed_ ^ robotlink::mixBits(++drawn_)) >> 11U) *
           0x1.0p-53;
  };
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

double NoiseProcess::erroneous(std::size_t channel, double value, double white) const {
  const NoiseModel& noise = of(channel);
  value += noise.mean + noise.stddev * white;
  if (!biases_.empty()) {
    const std::size_t own = std::min(channel, biases_.size() - 1);
    if (biased_) value += biases_[own];
    value += drift_[own];
  }
  return noise.precision > 0 ? std::round(value / noise.precision) * noise.precision : value;
}

}  // namespace simcore
