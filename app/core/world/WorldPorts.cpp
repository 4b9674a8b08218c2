// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/world/WorldPorts.h"

#include <algorithm>

#include "app/core/world/SimulatedWorld.h"
#include "app/core/world/WorldObjects.h"
#include "app/core/world/control/ExternalControllers.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/control/ControllerOutput.h"

namespace app {
namespace {

constexpr robotlink::Duration kControllerImages = std::chrono::milliseconds(40);

void addReading(google::protobuf::RepeatedPtrField<robotcontrol::PortReading>& to, const std::string& port,
                const std::vector<double>& values) {
  auto& reading = *to.Add();
  reading.set_port(port);
  for (const double value : values) reading.add_values(value);
}

}  // namespace

WorldPorts::WorldPorts(SimulatedWorld& world, const ExternalControllers* external, const WorldPorts* before)
    : world_(world), external_(external) {
  if (before == nullptr) return;
  for (const std::string& name : sensorNames())
    if (before->read_.contains(name)) read_.insert(name);
}

std::vector<std::string> WorldPorts::sensorNames() const {
  const simcore::Simulation& simulation = world_.simulation();
  std::vector<std::string> names;
  for (const auto& sensor : simulation.sensors()) names.push_back(sensor.info.path);
  for (const auto& sensor : simulation.rangeSensors()) names.push_back(sensor.info.path);
  for (const auto& camera : simulation.cameras()) names.push_back(camera.info.path);
  for (const auto* output : simulation.outputs()) names.push_back(output->info.path);
  if (external_ == nullptr) return names;
  for (const auto* output : external_->outputs()) names.push_back(output->info.path);
  return names;
}

void WorldPorts::addOutputs(robotcontrol::PortReadings& to) const {
  for (const auto* output : world_.simulation().outputs()) {
    if (read_.contains(output->info.path) && output->kind == simcore::ControllerOutput::Kind::kValues)
      addReading(*to.mutable_readings(), output->info.path, output->values);
  }
  if (external_ == nullptr) return;
  for (const auto* output : external_->outputs()) {
    if (read_.contains(output->info.path))
      addReading(*to.mutable_readings(), output->info.path, output->values);
  }
}

robotlink::Result<void> WorldPorts::read(const robotcontrol::ReadPorts& request) {
  if (request.ended()) {
    if (request.ports().empty()) read_.clear();
    for (const std::string& port : request.ports()) read_.erase(port);
    return {};
  }
  const auto known = sensorNames();
  for (const std::string& port : request.ports()) {
    if (std::ranges::find(known, port) == known.end()) {
      return robotlink::failure(
          "simulation.port", "there is no sensor " + port + robotlink::suggestion(port, known), {}, {port});
    }
  }
  read_.insert(request.ports().begin(), request.ports().end());
  // What robots send anyway is not sent twice.
  for (const auto& camera : world_.simulation().cameras())
    if (isSentByRobot(world_.simulation(), camera)) read_.erase(camera.info.path);
  return {};
}

robotlink::Result<void> WorldPorts::set(const std::string& robot, const robotcontrol::SetActuator& request,
                                        const std::vector<std::string>& stopped) {
  HeldActuators& held = world_.held();
  const std::string& port = request.port();
  const std::string model = port.substr(0, port.find('/'));
  if (!robot.empty() && !port.empty() && model != robot)
    return robotlink::failure("simulation.actuator", robot + " has no actuator " + port, {}, {robot, port});
  if (request.released()) {
    port.empty() ? held.releaseModel(world_.simulation(), robot) : held.release(world_.simulation(), port);
    return {};
  }
  if (std::ranges::find(stopped, model) != stopped.end())
    return robotlink::failure("simulation.stopped", model + " must not move; release STOP first", {},
                              {model});
  return held.hold(world_.simulation(), port, {request.values().begin(), request.values().end()});
}

void WorldPorts::release(const std::vector<std::string>& stopped) {
  for (const std::string& robot : stopped) world_.held().releaseModel(world_.simulation(), robot);
}

bool WorldPorts::isEmpty() const {
  return read_.empty() && !holdsAny();
}

bool WorldPorts::holdsAny() const {
  return !world_.held().all().empty();
}

std::shared_ptr<const robotcontrol::PortReadings> WorldPorts::readings() const {
  const simcore::Simulation& simulation = world_.simulation();
  auto message = std::make_shared<robotcontrol::PortReadings>();
  robotlink::assign(*message->mutable_timestamp(), world_.clock().now());
  for (const auto& sensor : simulation.sensors()) {
    if (read_.contains(sensor.info.path))
      addReading(*message->mutable_readings(), sensor.info.path, sensor.values);
  }
  const auto ranges = simulation.rangeSensors();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!read_.contains(ranges[i].info.path)) continue;
    std::vector<double> values(static_cast<std::size_t>(ranges[i].readings));
    simulation.measure(i, values);
    addReading(*message->mutable_readings(), ranges[i].info.path, values);
  }
  addOutputs(*message);
  for (const auto& [port, held] : world_.held().all())
    addReading(*message->mutable_held(), port, held.values);
  return message;
}

std::vector<robotlink::StreamMessage> WorldPorts::images(bool all) {
  std::vector<robotlink::StreamMessage> images;
  const auto cameras = world_.simulation().cameras();
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const std::string& path = cameras[i].info.path;
    if (!read_.contains(path) || !(all || world_.imageDue(i))) continue;
    auto image = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*image, world_.preview(i).view(), world_.clock().now(), path);
    images.push_back({path, world_.clock().now(), std::move(image)});
  }
  for (const auto* output : world_.simulation().outputs()) {
    const std::string& path = output->info.path;
    if (output->kind != simcore::ControllerOutput::Kind::kImage || !read_.contains(path)) continue;
    // As often as cameras take images.
    const bool isDue = world_.simulation().time() % kControllerImages < SimulatedWorld::kStep;
    if (!all && !isDue) continue;
    auto image = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*image, output->image.view(), world_.clock().now(), path);
    images.push_back({path, world_.clock().now(), std::move(image)});
  }
  return images;
}

}  // namespace app
