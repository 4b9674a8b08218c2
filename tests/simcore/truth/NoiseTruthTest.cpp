// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of every kind of sensor against their stated distributions, with fixed seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/Distribution.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

/// A body in the air with one sensor of each kind that yields numbers, before a wall.
std::string everything() {
  const std::string wall = "<geometry><box><size>0.2 400 400</size></box></geometry>";
  const std::string scan =
      "<scan><horizontal><samples>5</samples><min_angle>-0.4</min_angle><max_angle>0.4</max_angle></"
      "horizontal></scan>"
      "<range><min>0.01</min><max>1000</max></range>";
  const std::string ray =
      "<scan><horizontal><samples>1</samples><min_angle>0</min_angle><max_angle>0</max_angle></horizontal></"
      "scan>"
      "<range><min>0.01</min><max>1000</max></range>";
  const std::string limits =
      "<axis><xyz>0 0 "
      "1</xyz><limit><lower>-1</lower><upper>1</upper><effort>10</effort><velocity>5</velocity></limit></"
      "axis>";
  return "<gravity>0 0 0</gravity><model name='wall'><static>true</static><pose>100.1 0 0 0 0 0</pose><link "
         "name='l'><visual name='v'>" +
         wall + "</visual><collision name='c'>" + wall + "</collision></link></model>" +
         model("probe", "0 0 0 0 0 0",
               inertial(1, Vector3::Constant(0.1)) + sensorWith("imu", "imu") +
                   sensorWith("gyro", "imu", "<imu><angular_velocity><x/><y/><z/></angular_velocity></imu>") +
                   sensorWith("compass", "magnetometer") + sensorWith("gps", "navsat") +
                   sensorWith("height", "altimeter") +
                   sensorWith("odometry", "custom", "<robotcontrol:odometry/>") +
                   sensorWith("battery", "custom", "<robotcontrol:battery/>") +
                   sensorWith("laser", "lidar", "<lidar>" + scan + "</lidar>") +
                   sensorWith("psd", "lidar", "<lidar>" + ray + "</lidar>") +
                   sensorWith("sonar", "sonar",
                              "<sonar><min>0.01</min><max>1000</max><radius>10</radius></sonar>") +
                   sensorWith("depth", "depth_camera",
                              "<camera><horizontal_fov>0.5</horizontal_fov><image><width>8</width><height>6</"
                              "height></image>"
                              "<clip><near>0.1</near><far>1000</far></clip></camera>"),
               "<link name='arm'>" + inertial(1, Vector3::Constant(0.1)) +
                   "</link><joint name='hinge' type='revolute'><parent>body</parent><child>arm</child>" +
                   limits + "<robotcontrol:servo/><robotcontrol:speed_sensor/><robotcontrol:load_sensor/>" +
                   sensorWith("wrench", "force_torque") + "</joint><link name='tool'>" +
                   inertial(1, Vector3::Constant(0.1)) +
                   "</link><joint name='slide' type='prismatic'><parent>arm</parent><child>tool</child>" +
                   limits + "<robotcontrol:servo/></joint>");
}

/// All channels of a port; of an image all pixels.
std::vector<double> valuesOf(const Simulation& simulation, const Port& port) {
  return simulation.read(port.info.path).value();
}

std::vector<Port> sensorsOf(const Simulation& simulation) {
  std::vector<Port> found;
  for (const Port& port : simulation.ports()) {
    const bool isSensor = port.kind == Port::Kind::kSensor || port.kind == Port::Kind::kRange ||
                          port.kind == Port::Kind::kImage;
    if (isSensor) found.push_back(port);
  }
  return found;
}

/// A magnitude that suits the readings of a port, and does not meet the limits of its range.
double amountFor(const Port& port) {
  return port.info.type == "magnetic_field" ? 1e-6 : 0.01;
}

TEST(NoiseTruth, whiteNoiseOfEverySensorIsNormal) {
  const auto simulation = simulationOf(everything(), {.seed = 4, .noise = true});
  const auto ports = sensorsOf(*simulation);
  std::set<std::string> kinds;
  std::map<std::string, std::vector<double>> samples;
  for (const Port& port : ports) {
    const double amount = amountFor(port);
    ASSERT_TRUE(
        simulation->setSensorErrors(port.info.path, {.noise = {{.mean = 0.5 * amount, .stddev = amount}}}))
        << port.info.path;
    kinds.insert(port.info.type);
  }
  for (int i = 0; i < 2000; ++i) {
    simulation->step();
    for (const Port& port : ports) {
      const auto noisy = valuesOf(*simulation, port), exact = simulation->readTruth(port.info.path).value();
      // A few pixels of each image suffice.
      const std::size_t stride = noisy.size() > 10 ? 11 : 1;
      for (std::size_t k = 0; k < noisy.size(); k += stride)
        samples[port.info.path].push_back((noisy[k] - exact[k]) / amountFor(port));
    }
  }
  EXPECT_GE(kinds.size(), 12U) << "all kinds are there";
  for (const auto& [path, all] : samples) {
    compare({"white noise of each kind of sensor, Kolmogorov's distance", "normal distribution, n >= 2000", 0,
             kKolmogorovLimit, ""},
            kolmogorovOfNormal(all, 0.5, 1));
    EXPECT_LT(kolmogorovOfNormal(all, 0.5, 1), kKolmogorovLimit) << path;
  }
  // The test can fail: another deviation, or mean, is found.
  EXPECT_GT(kolmogorovOfNormal(samples.begin()->second, 0.5, 1.2), kKolmogorovLimit);
  EXPECT_GT(kolmogorovOfNormal(samples.begin()->second, 0.4, 1), kKolmogorovLimit);
}

TEST(NoiseTruth, biasesOfEverySensorAreNormalOverManyRuns) {
  const auto simulation = simulationOf(everything());
  const auto ports = sensorsOf(*simulation);
  std::vector<double> samples;
  for (const Port& port : ports) {
    ASSERT_TRUE(simulation->setSensorErrors(port.info.path, {.noise = {{.biasStddev = amountFor(port)}}}));
  }
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    simulation->reset(seed);
    simulation->step();
    for (const Port& port : ports) {
      samples.push_back((valuesOf(*simulation, port)[0] - simulation->readTruth(port.info.path).value()[0]) /
                        amountFor(port));
    }
  }
  compare({"bias of all sensors over 200 runs, Kolmogorov's distance", "normal distribution", 0,
           kKolmogorovLimit, ""},
          kolmogorovOfNormal(samples, 0, 1));
}

TEST(NoiseTruth, driftOfEverySensorIsAGaussMarkovProcess) {
  const double time = 0.05, deviation = 1;
  const auto simulation = simulationOf(everything());
  const auto ports = sensorsOf(*simulation);
  for (const Port& port : ports) {
    ASSERT_TRUE(simulation->setSensorErrors(
        port.info.path, {.noise = {{.driftStddev = deviation * amountFor(port), .driftTime = time}}}));
  }
  std::vector<double> samples;
  double product = 0, square = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    simulation->reset(seed);
    // After ten time constants it has forgotten that it began at 0.
    advance(*simulation, 10 * time);
    for (const Port& port : ports) {
      const auto now = [&] {
        return (valuesOf(*simulation, port)[0] - simulation->readTruth(port.info.path).value()[0]) /
               amountFor(port);
      };
      samples.push_back(now());
    }
    // After half a time constant it is exp(-0.5) of what it was, on average.
    const auto before = samples.size() - ports.size();
    advance(*simulation, 0.6 * time);
    for (std::size_t i = 0; i < ports.size(); ++i) {
      const double now =
          (valuesOf(*simulation, ports[i])[0] - simulation->readTruth(ports[i].info.path).value()[0]) /
          amountFor(ports[i]);
      product += now * samples[before + i];
      square += samples[before + i] * samples[before + i];
    }
  }
  const double stationary = deviation * std::sqrt(time / 2);
  compare({"drift of all sensors over 100 runs, Kolmogorov's distance", "normal distribution, s sqrt(T / 2)",
           0, kKolmogorovLimit, ""},
          kolmogorovOfNormal(samples, 0, stationary));
  // 0.6 time constants are 7.5 steps, rounded to 8.
  const double steps = std::round(0.6 * time / kStepSeconds);
  compare({"drift of all sensors, correlation after 0.6 time constants", "exp(-t / T)",
           std::exp(-steps * kStepSeconds / time), 0.08, ""},
          product / square);
}

TEST(NoiseTruth, roundedReadingsAreMultiplesWithUniformErrors) {
  const auto simulation = simulationOf(everything());
  const auto ports = sensorsOf(*simulation);
  std::map<std::string, std::vector<double>> errors;
  double off = 0;
  for (const Port& port : ports) {
    // The white noise is three times as large as the precision, so that the truth is anywhere between two
    // multiples.
    const double precision = amountFor(port) / 3;
    ASSERT_TRUE(simulation->setSensorErrors(
        port.info.path, {.noise = {{.stddev = amountFor(port), .precision = precision}}}));
  }
  std::vector<double> digits;
  for (int i = 0; i < 1000; ++i) {
    simulation->step();
    for (const Port& port : ports) {
      const double precision = amountFor(port) / 3, value = valuesOf(*simulation, port)[0];
      const double multiple = value / precision;
      if (std::abs(multiple) < 1e5) off = largerOf(off, std::abs(multiple - std::round(multiple)));
      // Whether it is even is like tossing a coin.
      digits.push_back(std::fmod(std::abs(std::round(multiple)), 2));
    }
  }
  // Images hold floats.
  compare({"precision, distance of readings from multiples of it", "0", 0, 0.01, ""}, off);
  compare({"precision, even and odd multiples, chi-square", "equally often", 0, kChiSquareLimit, ""},
          largerOf(0.0, chiSquareOfUniform(digits, 0, 2, 2)));
}

TEST(NoiseTruth, theStatedShareOfSamplesIsLostAndTheOthersComeLate) {
  const double dropout = 0.3, delay = 0.02;
  const auto simulation = simulationOf(everything());
  const std::string path = "probe/imu";
  ASSERT_TRUE(
      simulation->setSensorErrors(path, {.noise = {{.stddev = 1}}, .delay = delay, .dropout = dropout}));
  // Runs of equal readings: the previous sample stays while samples are lost.
  std::vector<double> lengths(6);
  double before = 0, length = 0, changes = 0;
  for (int i = 0; i < 5000; ++i) {
    simulation->step();
    const double now = read(*simulation, path);
    if (now != before && length > 0) {
      ++changes;
      ++lengths[static_cast<std::size_t>(std::min(length, 6.0)) - 1];
    }
    length = now == before ? length + 1 : 1;
    before = now;
  }
  std::vector<double> expected;
  double left = changes;
  for (int i = 0; i < 5; ++i) {
    expected.push_back(left * (1 - dropout));
    left *= dropout;
  }
  expected.push_back(left);
  compare({"dropout of 30 %, lengths of gaps, chi-square", "geometric distribution", 0, kChiSquareLimit, ""},
          largerOf(0.0, chiSquare(lengths, expected)));
}

TEST(NoiseTruth, everySensorIsLateByItsDelay) {
  const double delay = 0.048;
  // The probe turns and falls, so that all readings change.
  const auto simulation = simulationOf("<gravity>0 0 -9.81</gravity>" +
                                       everything().substr(std::string("<gravity>0 0 0</gravity>").size()));
  std::vector<Port> ports;
  for (const Port& port : sensorsOf(*simulation)) ports.push_back(port);
  for (const Port& port : ports) ASSERT_TRUE(simulation->setSensorErrors(port.info.path, {.delay = delay}));
  simulation->requestAngle(0, 1);
  const int late = 12;
  std::vector<std::vector<std::vector<double>>> past;
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    simulation->step();
    auto& now = past.emplace_back();
    for (const Port& port : ports) now.push_back(simulation->readTruth(port.info.path).value());
    if (i < late) continue;
    for (std::size_t k = 0; k < ports.size(); ++k) {
      const auto shown = valuesOf(*simulation, ports[k]);
      const auto& then = past[past.size() - 1 - late][k];
      for (std::size_t c = 0; c < shown.size(); ++c) {
        if (std::isfinite(then[c])) largest = largerOf(largest, std::abs(shown[c] - then[c]));
      }
    }
  }
  compare({"delay of 48 ms of each sensor, difference from the truth of 48 ms before", "0", 0, 1e-12, ""},
          largest);
}

}  // namespace
}  // namespace simcore::truth
