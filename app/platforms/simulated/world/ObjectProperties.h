// SPDX-License-Identifier: GPL-3.0-or-later
// Adds properties (mass, size, friction, ...) to the messages about objects of a simulated world.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robotcontrol/World.pb.h"
#include "robotlink/base/Geometry.h"

namespace simcore {
struct SensorErrors;
}

namespace app {

robotcontrol::WorldProperty& addNumbers(robotcontrol::WorldObject& to, const char* name,
                                        const std::vector<double>& values, const char* unit = "");
/// Adds nothing if the text is empty.
void addText(robotcontrol::WorldObject& to, const char* name, const std::string& text);
/// Adds what the motor of a joint reaches at most, and returns its speed and its torque; that of one that
/// slides has a force instead of a torque.
std::pair<robotcontrol::WorldProperty*, robotcontrol::WorldProperty*> addMotor(robotcontrol::WorldObject& to,
                                                                               bool slides, double speed,
                                                                               double torque);

/// The standard deviation of white noise; of several channels that of the first.
double whiteNoise(const simcore::SensorErrors& errors);

std::vector<double> componentsOf(const robotlink::Vector3& vector);
/// A pose as files have it: x y z roll pitch heading; m, rad.
std::vector<double> numbersOf(const robotlink::Pose3& pose);

}  // namespace app
