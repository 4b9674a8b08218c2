// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/Ports.h"

namespace simcore {
namespace {

/// Adds the ports of one moving model after the other, numbering bodies and hinges as Physics does.
class Collector {
 public:
  explicit Collector(Ports& ports) : ports_(ports) {}

  void add(const ModelInstance& model, int index) {
    model_ = index;
    name_ = model.name;
    if (model.type->isStatic) return;
    for (const JointDescription& joint : model.type->joints) {
      if (joint.kind != JointDescription::Kind::kHinge || joint.wheel) continue;
      addAngle(joint);
      if (joint.servo) addServo(joint);
      ++hinge_;
    }
    bodies_ = {static_cast<int>(body_) + 1, static_cast<int>(body_ + model.type->links.size()) + 1};
    for (const SensorDescription& sensor : model.type->sensors) addSensor(sensor);
    if (model.type->drive) addDrive(*model.type->drive);
    body_ += model.type->links.size();
  }

 private:
  PortInfo port(const std::string& path, const char* type, std::vector<int> shape, const char* unit) const {
    return {name_ + "/" + path, name_, type, std::move(shape), unit};
  }

  SensorSource source(SensorSource::Kind kind) const {
    SensorSource result;
    result.kind = kind;
    result.model = model_;
    return result;
  }

  void addAngle(const JointDescription& joint) {
    SensorSource from = source(SensorSource::Kind::kAngle);
    from.hinge = hinge_;
    from.noise = joint.positionNoise;
    ports_.sensors.push_back({port(joint.name + "/position", "angle", {}, "rad"), {joint.initialAngle}});
    ports_.sources.push_back(from);
  }

  void addServo(const JointDescription& joint) {
    ports_.servos.push_back({port(joint.name + "/request", "angle", {}, "rad"), joint.lower, joint.upper,
                             joint.maximumSpeed, joint.maximumTorque});
    ports_.servoStates.push_back({hinge_, joint.initialAngle, 1});
  }

  void addDrive(const DriveDescription& drive) {
    ports_.drives.push_back({port(drive.name, "wheel_speeds", {2}, "m/s"), drive.controller,
                             drive.wheelRadius, drive.track, drive.maximumSpeed});
    ports_.driveModels.push_back(model_);
  }

  void addSensor(const SensorDescription& sensor) {
    switch (sensor.kind) {
      case SensorDescription::Kind::kCamera:
        return addCamera(sensor);
      case SensorDescription::Kind::kDistance:
        return addReading(sensor, SensorSource::Kind::kDistance, port(sensor.name, "distance", {}, "m"), 1);
      case SensorDescription::Kind::kAccelerometer:
        return addReading(sensor, SensorSource::Kind::kAccelerometer,
                          port(sensor.name, "acceleration", {3}, "m/s^2"), 3);
      case SensorDescription::Kind::kGyroscope:
        return addReading(sensor, SensorSource::Kind::kGyroscope,
                          port(sensor.name, "angular_velocity", {3}, "rad/s"), 3);
      case SensorDescription::Kind::kContact:
        return addReading(sensor, SensorSource::Kind::kContact, port(sensor.name, "contact", {}, ""), 1);
      case SensorDescription::Kind::kSonar:
        return addRange(sensor, RangeSensor::Kind::kSonar);
      case SensorDescription::Kind::kLaser:
        return addRange(sensor, RangeSensor::Kind::kLaser);
    }
  }

  void addReading(const SensorDescription& sensor, SensorSource::Kind kind, PortInfo info, std::size_t size) {
    SensorSource from = source(kind);
    from.body = body_ + static_cast<std::size_t>(sensor.link);
    from.poseInLink = sensor.poseInLink;
    from.collision = sensor.collision;
    from.noise = sensor.noise;
    from.minimum = sensor.minimum;
    from.maximum = sensor.maximum;
    ports_.sensors.push_back({std::move(info), std::vector<double>(size)});
    ports_.sources.push_back(from);
  }

  void addCamera(const SensorDescription& sensor) {
    CameraSensor camera;
    camera.info = port(sensor.name + "/image", "image", {sensor.height, sensor.width, 3}, "");
    camera.model = {sensor.width, sensor.height, sensor.horizontalAngle, sensor.verticalAngle,
                    sensor.vignetting};
    // Body 0 of a RenderScene is the world.
    camera.body = static_cast<int>(body_) + sensor.link + 1;
    camera.cameraInBody = sensor.poseInLink;
    camera.period = robotlink::fromSeconds(1 / sensor.rate);
    camera.noise = sensor.noise;
    ports_.cameras.push_back(std::move(camera));
  }

  void addRange(const SensorDescription& sensor, RangeSensor::Kind kind) {
    const bool isLaser = kind == RangeSensor::Kind::kLaser;
    RangeSensor range;
    range.info =
        port(sensor.name, "range", isLaser ? std::vector{sensor.range.readings} : std::vector<int>{}, "m");
    range.kind = kind;
    range.minimum = sensor.minimum;
    range.maximum = sensor.maximum;
    range.noise = sensor.noise;
    range.readings = isLaser ? sensor.range.readings : 1;
    range.startAngle = sensor.range.startAngle;
    range.endAngle = sensor.range.endAngle;
    range.openingAngle = sensor.range.openingAngle;
    range.mostIncidence = sensor.range.mostIncidence;
    if (sensor.rate > 0) range.period = robotlink::fromSeconds(1 / sensor.rate);
    range.body = bodies_.first + sensor.link;
    range.sensorInBody = sensor.poseInLink;
    ports_.ranges.push_back(std::move(range));
    ports_.rangeOwners.push_back(bodies_);
  }

  Ports& ports_;
  // The bodies of the model; body 0 of a RenderScene is the world.
  RayCaster::BodyRange bodies_;
  std::string name_;
  int model_ = 0;
  std::size_t body_ = 0, hinge_ = 0;
};

}  // namespace

Ports Ports::of(const WorldDescription& world) {
  Ports ports;
  Collector collector(ports);
  for (std::size_t i = 0; i < world.models.size(); ++i) collector.add(world.models[i], static_cast<int>(i));
  return ports;
}

}  // namespace simcore
