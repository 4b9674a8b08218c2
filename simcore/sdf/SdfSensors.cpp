// SPDX-License-Identifier: GPL-3.0-or-later
// readSensors() of SdfConversion.h and readJointSensors() of SdfDevices.h.
#include <algorithm>
#include <cmath>

#include "simcore/physics/shapes/LumpedLink.h"
#include "simcore/sdf/SdfDevices.h"
#include "simcore/sdf/SdfUnsupported.h"

namespace simcore {
namespace {

using SensorKind = SensorDescription::Kind;

/// The noise of three axes; where only that of x is described, it counts for all.
std::vector<NoiseModel> noiseOfAxes(const sdf::Noise& x, const sdf::Noise& y, const sdf::Noise& z,
                                    const sdf::ElementPtr& axes, const SdfContext& context) {
  constexpr double kMost = 1000;
  const NoiseModel first = readNoise(x, kMost, axes, context);
  if (!axes || (!axes->HasElement("y") && !axes->HasElement("z"))) return {first};
  return {first, readNoise(y, kMost, axes, context), readNoise(z, kMost, axes, context)};
}

/// An accelerometer, or a gyroscope if only <angular_velocity> is described.
void readImu(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::Imu& imu = *sensor.ImuSensor();
  const sdf::ElementPtr turning = descendant(sensor.Element(), {"imu", "angular_velocity"}),
                        moving = descendant(sensor.Element(), {"imu", "linear_acceleration"});
  const bool turns = turning != nullptr && moving == nullptr;
  result.kind = turns ? SensorKind::kGyroscope : SensorKind::kAccelerometer;
  const sdf::ElementPtr axes = turns ? turning : moving;
  result.errors.noise = turns ? noiseOfAxes(imu.AngularVelocityXNoise(), imu.AngularVelocityYNoise(),
                                            imu.AngularVelocityZNoise(), axes, context)
                              : noiseOfAxes(imu.LinearAccelerationXNoise(), imu.LinearAccelerationYNoise(),
                                            imu.LinearAccelerationZNoise(), axes, context);
  if (turning && moving) {
    context.omit(turning, "<angular_velocity> beside <linear_acceleration> in <imu>",
                 "the sensor measures the acceleration; another imu, with <angular_velocity> alone, is a "
                 "gyroscope");
  }
  constexpr double kNoRange = SensorDescription::kNoRange;
  result.maximum = ownNumber(sensor.Element(), "range", kNoRange, 0.01, kNoRange, context);
  result.minimum = -result.maximum;
}

/// Returns whether the link has the solid.
bool readContact(const sdf::Sensor& sensor, const LinkDescription& link, SensorDescription& result,
                 const SdfContext& context) {
  result.kind = SensorKind::kContact;
  const sdf::ElementPtr element = sensor.Element()->GetElement("contact");
  const auto name = element->Get<std::string>("collision");
  const auto found = std::ranges::find(link.collisions, name, &CollisionDescription::name);
  if (found == link.collisions.end()) {
    context.omit(element, "contact sensor '" + sensor.Name() + "'",
                 isNoText(name) ? "its <contact> has no <collision> that names a solid"
                                : "the link '" + link.name + "' has no solid '" + name + "'");
    return false;
  }
  result.collision = static_cast<int>(found - link.collisions.begin());
  return true;
}

void readMagnetometer(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::Magnetometer& magnetometer = *sensor.MagnetometerSensor();
  result.kind = SensorKind::kMagnetometer;
  result.errors.noise = noiseOfAxes(magnetometer.XNoise(), magnetometer.YNoise(), magnetometer.ZNoise(),
                                    descendant(sensor.Element(), {"magnetometer"}), context);
}

void readNavSat(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::NavSat& navSat = *sensor.NavSatSensor();
  const auto noise = [&](const sdf::Noise& of) { return readNoise(of, 1000, sensor.Element(), context); };
  const NoiseModel position = noise(navSat.HorizontalPositionNoise()),
                   velocity = noise(navSat.HorizontalVelocityNoise());
  result.kind = SensorKind::kNavSat;
  result.errors.noise = {position, position, noise(navSat.VerticalPositionNoise()),
                         velocity, velocity, noise(navSat.VerticalVelocityNoise())};
}

void readAltimeter(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::Altimeter& altimeter = *sensor.AltimeterSensor();
  result.kind = SensorKind::kAltimeter;
  result.errors.noise = {readNoise(altimeter.VerticalPositionNoise(), 1000, sensor.Element(), context),
                         readNoise(altimeter.VerticalVelocityNoise(), 1000, sensor.Element(), context)};
}

void readBattery(const sdf::ElementPtr& element, SensorDescription& result, const SdfContext& context) {
  const auto number = [&](const char* name, double otherwise, double minimum, double maximum) {
    return ownNumber(element, name, otherwise, minimum, maximum, context);
  };
  result.kind = SensorKind::kBattery;
  BatteryDescription& battery = result.battery;
  battery.capacity = number("capacity", battery.capacity, 1e-3, 1e12);
  battery.charge = number("charge", battery.charge, 0, 1);
  battery.fullVoltage = number("full_voltage", battery.fullVoltage, 0, 1e5);
  battery.emptyVoltage =
      number("empty_voltage", std::min(battery.emptyVoltage, battery.fullVoltage), 0, battery.fullVoltage);
  battery.idlePower = number("idle_power", battery.idlePower, 0, 1e6);
  battery.efficiency = number("efficiency", battery.efficiency, 0.01, 1);
}

/// Reads one of our own sensors; returns false if it is none.
bool readOwnSensor(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::ElementPtr element = sensor.Element();
  if (element->HasElement("robotcontrol:facette")) {
    readFacettes(element, result, context);
  } else if (element->HasElement("robotcontrol:whisker")) {
    result.kind = SensorKind::kWhisker;
    result.maximum = context.within(element->Get<double>("robotcontrol:whisker"), 1e-3, 100,
                                    "the length of a whisker", element);
  } else if (element->HasElement("robotcontrol:battery")) {
    readBattery(element->GetElement("robotcontrol:battery"), result, context);
  } else if (element->HasElement("robotcontrol:odometry")) {
    result.kind = SensorKind::kOdometry;
  } else if (element->HasElement("robotcontrol:switch")) {
    result.kind = SensorKind::kSwitch;
  } else {
    return false;
  }
  result.rate = context.within(sensor.UpdateRate(), 0, 250, "an update_rate", element);
  return true;
}

/// Reads what only a sensor of its type has; returns false if there is no such sensor, which was noted.
bool readByType(const sdf::Sensor& sensor, const LinkDescription& link, SensorDescription& result,
                const SdfContext& context) {
  if (sensor.CameraSensor() != nullptr) {
    readCamera(sensor, result, context);
  } else if (sensor.LidarSensor() != nullptr) {
    readLidar(sensor, result, context);
  } else if (sensor.Type() == sdf::SensorType::SONAR) {
    readSonar(sensor, result, context);
  } else if (sensor.ImuSensor() != nullptr) {
    readImu(sensor, result, context);
  } else if (sensor.Type() == sdf::SensorType::CONTACT) {
    return readContact(sensor, link, result, context);
  } else if (sensor.MagnetometerSensor() != nullptr) {
    readMagnetometer(sensor, result, context);
  } else if (sensor.NavSatSensor() != nullptr) {
    readNavSat(sensor, result, context);
  } else if (sensor.AltimeterSensor() != nullptr) {
    readAltimeter(sensor, result, context);
  } else if (sensor.Type() != sdf::SensorType::CUSTOM || !readOwnSensor(sensor, result, context)) {
    context.omit(sensor.Element(), "sensor of type '" + sensor.TypeStr() + "'", kKnownSensors);
    return false;
  }
  return true;
}

/// Calls `read`, which says whether there is such a sensor; what is wrong with it leaves only that sensor
/// out. Returns false if it is left out.
template <typename Read>
bool readOrLeaveOut(const sdf::Sensor& sensor, const SdfContext& context, Read read) {
  bool isRead = false;
  const bool isSound = context.orLeaveOut(sensor.Element(), "sensor '" + sensor.Name() + "'",
                                          [&](const SdfContext& own) { isRead = read(own); });
  return isRead && isSound;
}

/// Whether the forces in a joint are those between two bodies; a model with a drive is moved as one body
/// where it follows its odometry.
bool isMeasurable(const JointDescription& joint, const ModelDescription& model) {
  return joint.kind == JointDescription::Kind::kFixed && !model.drive;
}

/// `bodies`: the rigidParts() of the model.
void readForceTorque(const sdf::Sensor& sensor, int joint, const std::vector<int>& bodies,
                     ModelDescription& model, const SdfContext& context) {
  const sdf::ElementPtr element = sensor.Element();
  JointDescription& of = model.joints[static_cast<std::size_t>(joint)];
  if (sensor.ForceTorqueSensor() == nullptr) {
    return context.omit(element, "sensor of type '" + sensor.TypeStr() + "'",
                        "joints only support force_torque sensors");
  }
  const std::string what = "force_torque sensor '" + sensor.Name() + "'";
  const bool isFixed = isMeasurable(of, model);
  if (!of.hasPosition() && !isFixed) {
    return context.omit(element, what,
                        "only revolute, continuous and prismatic joints that are not wheels have one, and "
                        "fixed ones of models without a drive");
  }
  const auto bodyOf = [&](int link) { return bodies[static_cast<std::size_t>(link)]; };
  if (isFixed && of.parent >= 0 && bodyOf(of.parent) == bodyOf(of.child)) {
    of.isMeasured = false;
    return context.omit(element, what, "other fixed joints connect the links of its joint as well");
  }
  const sdf::ForceTorque& meter = *sensor.ForceTorqueSensor();
  if (meter.Frame() != sdf::ForceTorqueFrame::CHILD) {
    context.omit(element, "<frame> of a force_torque sensor", "it measures in the frame of the child");
  }
  SensorDescription result;
  result.kind = SensorKind::kForceTorque;
  // Parts of models in models have names like "arm::hand".
  const std::size_t nested = of.name.rfind("::");
  result.name = (nested == std::string::npos ? "" : of.name.substr(0, nested + 2)) + sensor.Name();
  result.joint = joint;
  result.link = of.child;
  result.towardsParent = meter.MeasureDirection() != sdf::ForceTorqueMeasureDirection::PARENT_TO_CHILD;
  for (const sdf::Noise* noise : {&meter.ForceXNoise(), &meter.ForceYNoise(), &meter.ForceZNoise(),
                                  &meter.TorqueXNoise(), &meter.TorqueYNoise(), &meter.TorqueZNoise()}) {
    result.errors.noise.push_back(readNoise(*noise, 1e5, element, context));
  }
  readOwnErrors(element, result.errors, context);
  model.sensors.push_back(result);
}

}  // namespace

void readSensors(const sdf::Link& link, int linkIndex, ModelDescription& model, const SdfContext& context) {
  for (std::uint64_t i = 0; i < link.SensorCount(); ++i) {
    const sdf::Sensor& sensor = *link.SensorByIndex(i);
    SensorDescription result;
    result.name = sensor.Name();
    result.link = linkIndex;
    const LinkDescription& in = model.links[static_cast<std::size_t>(linkIndex)];
    const bool isRead = readOrLeaveOut(sensor, context, [&](const SdfContext& own) {
      result.poseInLink = resolvedPose(sensor.SemanticPose(), "", sensor.Element(), own);
      if (!readByType(sensor, in, result, own)) return false;
      readOwnErrors(sensor.Element(), result.errors, own);
      return true;
    });
    if (!isRead) continue;
    if (context.isStatic && !looksAround(result.kind)) {
      context.omit(sensor.Element(), "sensor '" + sensor.Name() + "' of a static model",
                   "only its cameras, lidars and sonars work; to use the others, fix the model to the world "
                   "with a joint");
      continue;
    }
    model.sensors.push_back(result);
    for (SensorDescription& depth : depthOfColorCamera(sensor, result)) model.sensors.push_back(depth);
  }
}

void readJointSensors(const sdf::Model& source, ModelDescription& model, const SdfContext& context) {
  std::vector<std::pair<int, const sdf::Sensor*>> sensors;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const sdf::Joint* joint = source.JointByName(model.joints[i].name);
    for (std::uint64_t s = 0; joint != nullptr && s < joint->SensorCount(); ++s) {
      sensors.emplace_back(static_cast<int>(i), joint->SensorByIndex(s));
      model.joints[i].isMeasured |=
          isMeasurable(model.joints[i], model) && joint->SensorByIndex(s)->ForceTorqueSensor() != nullptr;
    }
  }
  if (sensors.empty()) return;
  const std::vector<int> bodies = rigidParts(model);
  for (const auto& [joint, sensor] : sensors) readForceTorque(*sensor, joint, bodies, model, context);
}

}  // namespace simcore
