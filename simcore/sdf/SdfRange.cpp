// SPDX-License-Identifier: GPL-3.0-or-later
// readLidar() and readSonar() of SdfConversion.h: range sensors.
#include <algorithm>
#include <cmath>

#include "simcore/sdf/SdfDevices.h"

namespace simcore {

double updateRate(const sdf::Sensor& sensor, double slowest, const SdfContext& context) {
  constexpr double kFastest = 250;
  if (sensor.UpdateRate() > kFastest)
    context.omit(sensor.Element(), "update_rate above 250", "the sensor has 250 Hz");
  return context.within(std::min(sensor.UpdateRate(), kFastest), slowest, kFastest, "an update_rate",
                        sensor.Element());
}

namespace {

/// Whether the file has an element; libsdformat adds those that it looks for.
bool isInFile(const sdf::ElementPtr& parent, const char* name) {
  return parent->HasElement(name) && parent->GetElement(name)->LineNumber().has_value();
}

constexpr double kFarthest = 1000;  ///< m
constexpr int kMaxReadings = 10'000;

// With this limit a right-angled corner always gives an echo: a ray meets one of its faces at a smaller
// angle.
constexpr double kDefaultIncidence = robotlink::radians(55);

}  // namespace

void readLidar(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::Lidar& lidar = *sensor.LidarSensor();
  const sdf::ElementPtr element = sensor.Element();
  if (!isInFile(element, "lidar") && !isInFile(element, "ray"))
    return context.fail(element, "scene.lidar", "a lidar must say in <lidar> where it measures");
  result.kind = SensorDescription::Kind::kDistance;
  result.minimum = context.within(lidar.RangeMin(), 0, kFarthest, "a range", element);
  result.maximum =
      context.within(std::min(lidar.RangeMax(), kFarthest), result.minimum, kFarthest, "a range", element);
  result.errors.noise = {readNoise(lidar.LidarNoise(), 100, element, context)};
  if (lidar.VerticalScanSamples() != 1) {
    context.omit(element, "vertical samples of a lidar", "it measures in one plane, that of its x and y");
  }
  const unsigned samples = lidar.HorizontalScanSamples();
  if (samples == 1) return;
  result.kind = SensorDescription::Kind::kLaser;
  result.rate = updateRate(sensor, 0, context);
  result.range.readings =
      static_cast<int>(context.within(samples, 2, kMaxReadings, "a lidar's samples", element));
  const double start = lidar.HorizontalScanMinAngle().Radian();
  result.range.startAngle =
      context.within(start, -2 * robotlink::kPi, 2 * robotlink::kPi, "min_angle", element);
  result.range.endAngle = context.within(lidar.HorizontalScanMaxAngle().Radian(), start + 1e-3,
                                         start + 2 * robotlink::kPi, "max_angle", element);
}

void readSonar(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::ElementPtr element = sensor.Element();
  result.kind = SensorDescription::Kind::kSonar;
  if (!element->HasElement("sonar"))
    return context.fail(element, "scene.sonar", "a sonar must say in <sonar> where it measures");
  const sdf::ElementPtr sonar = element->GetElement("sonar");
  result.minimum = context.within(sonar->Get<double>("min"), 0, kFarthest, "a sonar's <min>", sonar);
  result.maximum =
      context.within(sonar->Get<double>("max"), result.minimum + 1e-3, kFarthest, "a sonar's <max>", sonar);
  const auto geometry = sonar->Get<std::string>("geometry", "cone").first;
  if (geometry != "cone") {
    context.omit(sonar, "<geometry> " + geometry + " of a sonar",
                 "it measures in a cone whose radius is that at its <max>");
  }
  const double radius =
      context.within(sonar->Get<double>("radius"), 1e-3, kFarthest, "a sonar's <radius>", sonar);
  result.range.openingAngle = 2 * std::atan(radius / std::max(result.maximum, 1e-3));
  // Slightly more than a right angle, because such angles are rounded in files.
  result.range.mostIncidence = ownNumber(element, "most_incidence", kDefaultIncidence, 0, 1.6, context);
  result.rate = updateRate(sensor, 0, context);
}

}  // namespace simcore
