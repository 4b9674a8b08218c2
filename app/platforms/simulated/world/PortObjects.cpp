// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/PortObjects.h"

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "app/platforms/simulated/world/ObjectProperties.h"
#include "app/platforms/simulated/world/PortRanges.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/world/WorldDescription.h"

namespace app {
namespace {

using robotcontrol::WorldObject;
using robotlink::Pose3;
using ElementPath = std::vector<std::string>;

const simcore::ModelInstance* modelNamed(const simcore::Simulation& simulation, const std::string& name) {
  const auto& models = simulation.scene().world().models;
  const auto found = std::ranges::find(models, name, &simcore::ModelInstance::name);
  return found == models.end() ? nullptr : &*found;
}

class PortWriter {
 public:
  PortWriter(const simcore::Simulation& simulation, robotcontrol::WorldObjects& to)
      : simulation_(simulation), to_(to) {
    for (const auto& object : to.objects()) known_.insert(object.path());
    for (const auto& sensor : simulation.sensors()) add(sensor.info);
    for (const auto& sensor : simulation.rangeSensors()) add(sensor.info);
    for (const auto& camera : simulation.cameras())
      add(camera.info).mutable_port()->set_image_stream(imageStreamOf(simulation, camera));
    for (const auto& sensor : simulation.imageSensors())
      add(sensor.info).mutable_port()->set_image_stream(sensor.info.path);
    for (const auto& servo : simulation.servos()) {
      WorldObject& object = addActuator(servo.info);
      const std::string& unit = servo.info.unit;
      addMotor(object, unit == "m" || unit == "m/s" || unit == "N", servo.maximumSpeed, servo.maximumTorque);
    }
    for (const auto& drive : simulation.drives()) {
      WorldObject& object = addActuator(drive.info);
      addNumbers(object, "track", {drive.track}, "m");
      addNumbers(object, "wheel_radius", {drive.wheelRadius}, "m");
    }
    for (const auto& guide : simulation.guides())
      addNumbers(addActuator(guide.info), "maximum_speed", {guide.motion.maximumSpeed}, "m/s");
    for (const auto& door : simulation.doors()) addActuator(door.info);
  }

 private:
  WorldObject& addActuator(const simcore::PortInfo& info) {
    WorldObject& object = add(info);
    object.set_kind(WorldObject::ACTUATOR);
    object.mutable_port()->set_is_actuator(true);
    return object;
  }

  /// Adds the range of each number where they differ.
  void addRanges(WorldObject& object, const simcore::PortInfo& info) const {
    const simcore::Port* port = simulation_.port(info.path);
    if (port == nullptr || info.shape.size() > 1) return;
    const std::vector<ValueRange> ranges = rangesOf(simulation_, *port);
    if (std::ranges::adjacent_find(ranges, std::not_equal_to()) == ranges.end()) return;
    std::vector<double> minimums, maximums;
    for (const ValueRange& range : ranges) {
      minimums.push_back(range.minimum);
      maximums.push_back(range.maximum);
    }
    addNumbers(object, "minimum", minimums, info.unit.c_str());
    addNumbers(object, "maximum", maximums, info.unit.c_str());
  }

  WorldObject& add(const simcore::PortInfo& info) {
    WorldObject& object = *to_.add_objects();
    object.set_kind(WorldObject::SENSOR);
    object.set_path(info.path);
    object.set_name(info.path.substr(std::min(info.path.size(), info.robot.size() + 1)));
    object.set_model(info.robot);
    object.set_parent(info.robot);
    auto& port = *object.mutable_port();
    port.set_path(info.path);
    port.set_robot(info.robot);
    port.set_type(info.type);
    port.set_unit(info.unit);
    for (const int size : info.shape) port.add_shape(size);
    port.set_minimum(info.minimum);
    port.set_maximum(info.maximum);
    addRanges(object, info);
    const std::string first = object.name().substr(0, object.name().find('/'));
    if (const std::string joint = info.robot + "/joint:" + first; known_.contains(joint)) {
      object.set_parent(joint);
    } else {
      describeSensor(object, first);
    }
    return object;
  }

  /// Adds what the model's file says about the sensor: its pose, and its noise.
  void describeSensor(WorldObject& object, const std::string& name) const {
    const auto* model = modelNamed(simulation_, object.model());
    if (model == nullptr) return;
    const auto& sensors = model->type->sensors;
    const auto sensor = std::ranges::find(sensors, name, &simcore::SensorDescription::name);
    if (sensor == sensors.end()) return;
    const std::string& link = model->type->links[static_cast<std::size_t>(sensor->link)].name;
    object.set_parent(object.model() + "/link:" + link);
    if (model->type->isStatic) {
      const auto& inModel = model->type->links[static_cast<std::size_t>(sensor->link)].poseInModel;
      object.set_frame("field");
      robotlink::assign(*object.mutable_pose_in_frame(),
                        Pose3(model->poseInWorld * inModel * sensor->poseInLink));
    } else {
      object.set_frame("body:" + object.model() + "/" + link);
      robotlink::assign(*object.mutable_pose_in_frame(), sensor->poseInLink);
    }
    using Kind = simcore::SensorDescription::Kind;
    const bool isFacettes =
        sensor->kind == Kind::kImage && sensor->image.kind == simcore::ImageGeometry::Kind::kFacette;
    const bool isCamera = sensor->kind == Kind::kCamera;
    const bool isInScene = model->type->file == simulation_.scene().file().string();
    const auto locate = [&](robotcontrol::WorldProperty& property, const ElementPath& steps) {
      if (model->type->file.empty()) return;
      property.set_file(model->type->file);
      property.add_element(isInScene ? "instance[" + object.model() + "]" : "model");
      property.add_element("link[" + link + "]");
      property.add_element("sensor[" + name + "]");
      for (const std::string& step : steps) property.add_element(step);
    };
    if (isCamera || (sensor->kind == Kind::kImage && !isFacettes)) {
      locate(addNumbers(object, "pixels", {double(sensor->width), double(sensor->height)}, "px"),
             {"camera", "image", "width,height"});
      locate(addNumbers(object, "opening_angles", {sensor->horizontalAngle, sensor->verticalAngle}, "rad"),
             {"camera", "horizontal_fov,robotcontrol:vertical_fov"});
    }
    if (isFacettes) {
      const auto& image = sensor->image;
      addNumbers(object, "size", {double(image.camera.width), double(image.camera.height)});
      addNumbers(object, "azimuth", {image.azimuthStart, image.azimuthEnd}, "rad");
      addNumbers(object, "elevation", {image.elevationStart, image.elevationEnd}, "rad");
    }
    if (sensor->kind == Kind::kSonar)
      addNumbers(object, "opening_angle", {sensor->range.openingAngle}, "rad");
    const bool isLidar = sensor->kind == Kind::kDistance || sensor->kind == Kind::kLaser;
    if (sensor->kind == Kind::kLaser)
      locate(addNumbers(object, "angles", {sensor->range.startAngle, sensor->range.endAngle}, "rad"),
             {"lidar|ray", "scan", "horizontal", "min_angle,max_angle"});
    if (isLidar)
      locate(addNumbers(object, "range", {sensor->minimum, sensor->maximum}, "m"),
             {"lidar|ray", "range", "min,max"});
    if (sensor->rate > 0) locate(addNumbers(object, "rate", {sensor->rate}, "Hz"), {"update_rate"});
    if (sensor->kind == Kind::kContact) return;
    locate(addNumbers(object, "delay", {sensor->errors.delay}, "s"), {"robotcontrol:delay"});
    locate(addNumbers(object, "dropout", {sensor->errors.dropout}), {"robotcontrol:dropout"});
    auto& noise = addNumbers(object, "noise", {whiteNoise(sensor->errors)},
                             isCamera ? "" : object.port().unit().c_str());
    const ElementPath steps = noiseSteps(isFacettes ? Kind::kSonar : sensor->kind);
    locate(noise, steps.empty() ? ElementPath{"robotcontrol:noise"} : steps);
  }

  /// Empty for those that describe the noise of several axes; one element of ours is for all of them.
  static ElementPath noiseSteps(simcore::SensorDescription::Kind kind) {
    using Kind = simcore::SensorDescription::Kind;
    if (kind == Kind::kCamera || kind == Kind::kImage) return {"camera", "noise", "stddev"};
    if (kind == Kind::kDistance || kind == Kind::kLaser) return {"lidar|ray", "noise", "stddev"};
    if (kind == Kind::kSonar) return {"robotcontrol:noise"};
    return {};
  }

  const simcore::Simulation& simulation_;
  robotcontrol::WorldObjects& to_;
  std::set<std::string> known_;
};

}  // namespace

void addPorts(const simcore::Simulation& simulation, robotcontrol::WorldObjects& to) {
  const PortWriter writer(simulation, to);
}

bool isSentByRobot(const simcore::Simulation& simulation, const simcore::CameraSensor& camera) {
  const auto* model = modelNamed(simulation, camera.info.robot);
  return model != nullptr && !model->type->robot.empty() && !model->type->drive;
}

std::string imageStreamOf(const simcore::Simulation& simulation, const simcore::CameraSensor& camera) {
  return isSentByRobot(simulation, camera) ? camera.info.robot + "/" + robotlink::kCameraImage.name
                                           : camera.info.path;
}

}  // namespace app
