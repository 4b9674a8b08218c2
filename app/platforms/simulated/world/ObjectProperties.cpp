// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/ObjectProperties.h"

#include <algorithm>
#include <cmath>

#include "simcore/world/SensorErrors.h"

namespace app {

using robotcontrol::WorldObject;

robotcontrol::WorldProperty& addNumbers(WorldObject& to, const char* name, const std::vector<double>& values,
                                        const char* unit) {
  auto& property = *to.add_properties();
  property.set_name(name);
  property.set_unit(unit);
  for (const double value : values) property.add_values(value);
  return property;
}

std::vector<double> componentsOf(const robotlink::Vector3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

std::vector<double> numbersOf(const robotlink::Pose3& pose) {
  const robotlink::Vector3 place = pose.translation();
  const Eigen::Matrix3d turn = pose.linear();
  return {place.x(),
          place.y(),
          place.z(),
          std::atan2(turn(2, 1), turn(2, 2)),
          0.0 - std::asin(std::clamp(turn(2, 0), -1.0, 1.0)),  // not -0
          std::atan2(turn(1, 0), turn(0, 0))};
}

std::pair<robotcontrol::WorldProperty*, robotcontrol::WorldProperty*> addMotor(WorldObject& to, bool slides,
                                                                               double speed, double torque) {
  auto& fastest = addNumbers(to, "maximum_speed", {speed}, slides ? "m/s" : "rad/s");
  auto& strongest =
      addNumbers(to, slides ? "maximum_force" : "maximum_torque", {torque}, slides ? "N" : "N m");
  return {&fastest, &strongest};
}

void addText(WorldObject& to, const char* name, const std::string& text) {
  if (text.empty()) return;
  auto& property = *to.add_properties();
  property.set_name(name);
  property.set_text(text);
}

double whiteNoise(const simcore::SensorErrors& errors) {
  return errors.noise.empty() ? 0 : errors.noise.front().stddev;
}

}  // namespace app
