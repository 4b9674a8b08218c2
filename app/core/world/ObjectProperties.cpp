// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/world/ObjectProperties.h"

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
