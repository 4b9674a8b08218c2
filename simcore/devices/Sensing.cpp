// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/Sensing.h"

#include <algorithm>

#include "robotlink/base/Random.h"
#include "simcore/physics/Step.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// Samples that are on their way: one in each step of the longest delay.
constexpr std::size_t kMaxSamples = 512;

}  // namespace

Sensing::Sensing(const Physics& physics, const std::vector<SensorSource>& sources,
                 const WorldDescription& world)
    : sources_(sources), exact_(physics, sources, world) {
  for (const SensorSource& source : sources_) {
    State& state = states_.emplace_back(
        State{source.errors,
              NoiseProcess(source.stream, source.size, kStepSeconds, source.errors.noise),
              std::nullopt,
              {},
              false});
    if (source.errors.hasTiming()) state.clock = clockOf(source, source.errors);
  }
}

SampleClock Sensing::clockOf(const SensorSource& source, const SensorErrors& errors) {
  return {errors, robotlink::hashBits(source.stream.domain, source.stream.index, 0), kStepSeconds};
}

void Sensing::afterStep(const Noise& noise) {
  if (noise.step > 0) exact_.afterStep();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i].clock) takeSample(i, noise);
  }
}

void Sensing::takeSample(std::size_t index, const Noise& noise) {
  State& state = states_[index];
  const bool due =
      state.samples.empty() || !state.isOn(noise) || state.clock->sampleAt(noise.seed, noise.step);
  if (due) {
    Sample& sample =
        state.samples.emplace_back(Sample{noise.step, std::vector<double>(sources_[index].size)});
    measure(index, noise, sample.values);
  }
  const std::uint64_t delay = state.isOn(noise) ? state.clock->delay() : 0;
  while (state.samples.size() > 1 && state.samples[1].step + delay <= noise.step) state.samples.pop_front();
}

void Sensing::measure(std::size_t index, const Noise& noise, std::vector<double>& values) {
  const SensorSource& source = sources_[index];
  exact_.read(index, values);
  if (states_[index].isOn(noise)) states_[index].noise.apply(noise.seed, noise.step, values);
  if (source.maximum <= source.minimum) return;
  for (double& value : values) value = std::clamp(value, source.minimum, source.maximum);
}

void Sensing::read(const Noise& noise, std::size_t index, Sensor& sensor) {
  const State& state = states_[index];
  if (state.clock && !state.samples.empty()) {
    sensor.values = state.samples.front().values;
    sensor.step = state.samples.front().step;
    return;
  }
  measure(index, noise, sensor.values);
  sensor.step = noise.step;
}

void Sensing::read(const Noise& noise, std::vector<Sensor>& sensors) {
  for (std::size_t i = 0; i < sources_.size(); ++i) read(noise, i, sensors[i]);
}

void Sensing::transferSamples(StateStream& stream, std::size_t index, std::uint64_t step) {
  State& state = states_[index];
  stream.size(state.samples, kMaxSamples);
  for (Sample& sample : state.samples) {
    stream.upTo(sample.step, step);
    sample.values.resize(sources_[index].size);
    for (double& value : sample.values) stream.raw(value);
  }
  // A sensor with a timing always has a sample that can be read.
  stream.require(state.clock.has_value() != state.samples.empty());
}

void Sensing::transfer(StateStream& stream, const Noise& noise) {
  exact_.transfer(stream);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    State& state = states_[i];
    transferErrors(stream, state.errors);
    stream.flag(state.chosen);
    state.noise.transfer(stream, noise.seed, noise.step);
    if (stream.isReading()) {
      state.clock.reset();
      if (state.errors.hasTiming()) state.clock = clockOf(sources_[i], state.errors);
    }
    transferSamples(stream, i, noise.step);
    if (!stream.good()) return;
  }
}

void Sensing::setErrors(std::size_t index, const SensorErrors& errors, const Noise& noise) {
  State& state = states_[index];
  state.errors = errors;
  state.chosen = true;
  state.noise.change(errors.noise, noise.seed, noise.step);
  state.clock.reset();
  if (errors.hasTiming()) {
    state.clock = clockOf(sources_[index], errors);
    if (state.samples.empty()) takeSample(index, noise);
  } else {
    state.samples.clear();
  }
}

}  // namespace simcore
