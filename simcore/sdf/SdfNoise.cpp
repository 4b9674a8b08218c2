// SPDX-License-Identifier: GPL-3.0-or-later
// readNoise(), readOwnErrors() and our own elements of SdfDevices.h.
#include <cmath>
#include <limits>

#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

constexpr double kMaxNoise = 1e6;

/// One of our own elements for a property of noise.
struct OwnNoise {
  const char* name;
  double NoiseModel::*value;
  double minimum;
};

constexpr OwnNoise kOwnNoise[] = {{"noise", &NoiseModel::stddev, 0},
                                  {"mean", &NoiseModel::mean, -kMaxNoise},
                                  {"bias_mean", &NoiseModel::biasMean, -kMaxNoise},
                                  {"bias_stddev", &NoiseModel::biasStddev, 0},
                                  {"drift_stddev", &NoiseModel::driftStddev, 0},
                                  {"drift_time", &NoiseModel::driftTime, 0},
                                  {"precision", &NoiseModel::precision, 0}};

}  // namespace

double ownNumber(const sdf::ElementPtr& parent, const char* name, double otherwise, double minimum,
                 double maximum, const SdfContext& context) {
  const std::string key = std::string("robotcontrol:") + name;
  if (!parent->HasElement(key)) return otherwise;
  const sdf::ElementPtr element = parent->GetElement(key);
  const auto value = element->Get<double>();
  const bool isSound = context.orLeaveOut(element, "<" + key + ">", [&](const SdfContext& own) {
    own.within(value, minimum, maximum, name, element);
  });
  return isSound ? value : otherwise;
}

std::vector<std::string> ownTexts(const sdf::ElementPtr& parent, const char* name) {
  const std::string key = std::string("robotcontrol:") + name;
  std::vector<std::string> texts;
  for (sdf::ElementPtr child = parent->GetFirstElement(); child; child = child->GetNextElement()) {
    if (child->GetName() == key) texts.push_back(child->Get<std::string>());
  }
  return texts;
}

sdf::ElementPtr descendant(sdf::ElementPtr element, std::initializer_list<const char*> path) {
  for (const char* name : path) {
    if (!element || !element->HasElement(name)) return nullptr;
    element = element->GetElement(name);
  }
  return element;
}

NoiseModel readNoise(const sdf::Noise& noise, double most, const sdf::ElementPtr& element,
                     const SdfContext& context) {
  NoiseModel result;
  result.mean = context.within(noise.Mean(), -kMaxNoise, kMaxNoise, "mean", element);
  result.stddev = context.within(noise.StdDev(), 0, most, "stddev", element);
  result.biasMean = context.within(noise.BiasMean(), -kMaxNoise, kMaxNoise, "bias_mean", element);
  result.biasStddev = context.within(noise.BiasStdDev(), 0, kMaxNoise, "bias_stddev", element);
  result.driftStddev =
      context.within(noise.DynamicBiasStdDev(), 0, kMaxNoise, "dynamic_bias_stddev", element);
  result.driftTime = context.within(noise.DynamicBiasCorrelationTime(), 0, kMaxNoise,
                                    "dynamic_bias_correlation_time", element);
  if (noise.Type() == sdf::NoiseType::GAUSSIAN_QUANTIZED)
    result.precision = context.within(noise.Precision(), 0, kMaxNoise, "precision", element);
  return result;
}

void readOwnErrors(const sdf::ElementPtr& element, SensorErrors& errors, const SdfContext& context) {
  for (const OwnNoise& own : kOwnNoise) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const double value = ownNumber(element, own.name, kNone, own.minimum, kMaxNoise, context);
    if (std::isnan(value)) continue;
    if (errors.noise.empty()) errors.noise.emplace_back();
    for (NoiseModel& noise : errors.noise) noise.*own.value = value;
  }
  errors.delay = ownNumber(element, "delay", 0, 0, SensorErrors::kMaxDelay, context);
  errors.rate = ownNumber(element, "rate", 0, 0, 1000, context);
  errors.dropout = ownNumber(element, "dropout", 0, 0, 1, context);
}

}  // namespace simcore
