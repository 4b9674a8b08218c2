// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "simcore/devices/ExactSensing.h"
#include "simcore/devices/Ports.h"
#include "simcore/noise/NoiseProcess.h"
#include "simcore/noise/SampleClock.h"
#include "simcore/physics/Physics.h"

namespace simcore {

class StateStream;

/// Computes the readings of sensors from the state of the world, with their errors. The errors depend only on
/// seed, sensor and step, so it does not matter how often, or whether, readings are requested. afterStep()
/// must be called after every step. One thread at a time.
class Sensing {
 public:
  /// All arguments must outlive it.
  Sensing(const Physics& physics, const std::vector<SensorSource>& sources, const WorldDescription& world);

  using Noise = NoiseSelection;
  /// Updates what is measured over time, and takes the samples that are due of sensors that have a timing.
  /// Also to be called before the first step, with `step` 0.
  void afterStep(const Noise& noise);
  /// A model was put elsewhere by hand and is at rest: its velocity before that means nothing.
  void forgetVelocitiesOf(int model) { exact_.forgetVelocitiesOf(model); }
  /// A model was set in motion by hand: it has had this velocity before, too.
  void adoptVelocitiesOf(int model) { exact_.adoptVelocitiesOf(model); }

  /// Computes all readings; sensors[i] is measured by sources[i].
  void read(const Noise& noise, std::vector<Sensor>& sensors);
  /// Computes one reading.
  void read(const Noise& noise, std::size_t index, Sensor& sensor);
  /// The reading without errors and delay; `values` has its size.
  void readExactly(std::size_t index, std::vector<double>& values) const { exact_.read(index, values); }

  /// Replaces the errors of a sensor from this step on, and applies them even where noise is off; samples
  /// that were taken before remain as they are.
  void setErrors(std::size_t index, const SensorErrors& errors, const Noise& noise);
  /// Writes or reads everything; `noise` is that of the present step.
  void transfer(StateStream& stream, const Noise& noise);
  const SensorErrors& errors(std::size_t index) const { return states_[index].errors; }

 private:
  struct Sample {
    std::uint64_t step = 0;
    std::vector<double> values;
  };
  /// The errors of one sensor.
  struct State {
    SensorErrors errors;
    NoiseProcess noise;
    /// Only if it has a timing; then its samples, in the order of time, of which the first can be read.
    std::optional<SampleClock> clock;
    std::deque<Sample> samples;
    /// Whether a user chose the errors, instead of the scene.
    bool chosen = false;
    bool isOn(const Noise& of) const { return of.on || chosen; }
  };
  /// A sample of this step, with noise, in the range of the sensor.
  void measure(std::size_t index, const Noise& noise, std::vector<double>& values);
  void transferSamples(StateStream& stream, std::size_t index, std::uint64_t step);
  void takeSample(std::size_t index, const Noise& noise);
  static SampleClock clockOf(const SensorSource& source, const SensorErrors& errors);

  const std::vector<SensorSource>& sources_;
  ExactSensing exact_;
  std::vector<State> states_;
};

}  // namespace simcore
