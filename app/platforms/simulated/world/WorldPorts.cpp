// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/WorldPorts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "app/platforms/simulated/world/PortObjects.h"
#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "app/platforms/simulated/world/control/ControlMessages.h"
#include "app/platforms/simulated/world/control/ExternalControllers.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/control/ControllerOutput.h"

namespace app {
namespace {

using robotlink::Rgb;

/// The period of images that controllers show, and of those of sensors that have none.
constexpr robotlink::Duration kUsualPeriod = std::chrono::milliseconds(40);
/// Sensors that yield more numbers are published as images only.
constexpr std::size_t kMaxNumbers = 10'000;

void addReading(google::protobuf::RepeatedPtrField<robotcontrol::PortReading>& to, const std::string& port,
                const std::vector<double>& values) {
  auto& reading = *to.Add();
  reading.set_port(port);
  for (const double value : values) reading.add_values(value);
}

/// Sets the color of each class of a scene, 0 being none.
std::vector<Rgb> colorsOfLabels(const simcore::RenderScene& scene) {
  std::vector<Rgb> colors(scene.labelNames.size() + 1);
  for (std::size_t i = 0; i < scene.instances.size() && i < scene.labels.size(); ++i)
    colors[scene.labels[i]] = scene.instances[i].color;
  colors[0] = {};
  return colors;
}

/// Radiation as it is seen: Y, Cb and Cr as colors, three other classes as red, green and blue, of others the
/// first one. What is no gray value is as bright as the brightest one allows.
robotlink::Image radiationImage(const simcore::ImageSensor& sensor, std::span<const float> values) {
  const std::vector<std::string>& classes = sensor.geometry.classes;
  const std::size_t channels = std::max<std::size_t>(1, classes.size()), shown = channels == 3 ? 3 : 1;
  const auto isGray = [](const std::string& name) {
    return name == "Y" || name == "Cb" || name == "Cr" || name == "R" || name == "G" || name == "B";
  };
  float scale = 1;
  if (!std::ranges::all_of(classes, isGray)) {
    float brightest = 0;
    for (const float value : values)
      brightest = std::isfinite(value) ? std::max(brightest, value) : brightest;
    scale = brightest > 0 ? 255 / brightest : 1;
  }
  const auto byteOf = [scale](float value) {
    return static_cast<std::uint8_t>(std::isfinite(value) ? std::clamp(value * scale + 0.5F, 0.F, 255.F)
                                                          : 0.F);
  };
  robotlink::Image image(sensor.geometry.camera.width, sensor.geometry.camera.height,
                         shown == 3 ? robotlink::PixelFormat::kRgb8 : robotlink::PixelFormat::kMono8);
  const bool isChroma = classes == std::vector<std::string>{"Y", "Cb", "Cr"};
  for (std::size_t i = 0; i * channels + channels <= values.size(); ++i) {
    std::uint8_t* const pixel = &image.data[i * shown];
    for (std::size_t k = 0; k < shown; ++k) pixel[k] = byteOf(values[i * channels + k]);
    if (!isChroma) continue;
    const Rgb color = robotlink::toRgb({pixel[0], pixel[1], pixel[2]});
    pixel[0] = color.r;
    pixel[1] = color.g;
    pixel[2] = color.b;
  }
  return image;
}

/// Returns an image sensor's measurement as an image: depth in m, classes in the colors that they name.
std::shared_ptr<foxglove::RawImage> measuredImage(const simcore::Simulation& simulation, std::size_t index,
                                                  robotlink::Instant time) {
  const simcore::ImageSensor& sensor = simulation.imageSensors()[index];
  const simcore::CameraModel& camera = sensor.geometry.camera;
  std::vector<float> values(sensor.values());
  simulation.measureImage(index, values);
  auto message = std::make_shared<foxglove::RawImage>();
  using Kind = simcore::ImageGeometry::Kind;
  if (sensor.geometry.kind == Kind::kLabels) {
    const std::vector<Rgb> colors = colorsOfLabels(*simulation.renderScene());
    robotlink::Image image(camera.width, camera.height, robotlink::PixelFormat::kRgb8);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Rgb color = colors[std::min(static_cast<std::size_t>(values[i]), colors.size() - 1)];
      std::ranges::copy(std::array{color.r, color.g, color.b}, &image.data[3 * i]);
    }
    robotlink::assign(*message, image.view(), time, sensor.info.path);
    return message;
  }
  if (sensor.geometry.kind != Kind::kDepth) {
    robotlink::assign(*message, radiationImage(sensor, values).view(), time, sensor.info.path);
    return message;
  }
  robotlink::assign(*message->mutable_timestamp(), time);
  message->set_frame_id(sensor.info.path);
  message->set_width(static_cast<std::uint32_t>(camera.width));
  message->set_height(static_cast<std::uint32_t>(camera.height));
  message->set_encoding("32FC1");
  message->set_step(static_cast<std::uint32_t>(camera.width * static_cast<int>(sizeof(float))));
  message->set_data(values.data(), values.size() * sizeof(float));
  return message;
}

}  // namespace

WorldPorts::WorldPorts(SimulatedWorld& world, const ExternalControllers* external, const WorldPorts* before)
    : world_(world), external_(external) {
  if (before != nullptr) read_ = before->read_;
}

std::vector<std::string> WorldPorts::readable() const {
  std::vector<std::string> names = world_.simulation().readablePaths();
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

void WorldPorts::addTruth(robotcontrol::PortReadings& to) const {
  for (const std::string& path : read_) {
    const simcore::Port* const port = world_.simulation().port(path);
    const bool isTruth = port != nullptr ? port->isTruth() : world_.simulation().portOfTruth(path) != nullptr;
    if (!isTruth) continue;
    auto reading = readingOf(world_.simulation(), path);
    if (reading && static_cast<std::size_t>(reading->values_size()) <= kMaxNumbers)
      *to.add_readings() = *std::move(reading);
  }
}

robotlink::Result<void> WorldPorts::read(const robotcontrol::ReadPorts& request) {
  if (request.ended()) {
    if (request.ports().empty()) read_.clear();
    for (const std::string& port : request.ports()) read_.erase(port);
    return {};
  }
  const auto known = readable();
  for (const std::string& port : request.ports()) {
    if (std::ranges::find(known, port) == known.end()) {
      return robotlink::failure("simulation.port",
                                "there is no sensor or actuator " + port + robotlink::suggestion(port, known),
                                {}, {port});
    }
  }
  for (const std::string& port : request.ports()) {
    if (world_.simulation().portOfTruth(port) == nullptr) continue;
    const auto reading = readingOf(world_.simulation(), port);
    if (reading && static_cast<std::size_t>(reading->values_size()) > kMaxNumbers)
      return robotlink::failure(
          "simulation.port",
          port + " has more than " + std::to_string(kMaxNumbers) + " numbers; a controller can read it", {},
          {port});
  }
  read_.insert(request.ports().begin(), request.ports().end());
  // Images that robots send anyway are not sent twice.
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
  for (const auto& sensor : simulation.imageSensors()) {
    if (!read_.contains(sensor.info.path) || sensor.values() > kMaxNumbers) continue;
    addReading(*message->mutable_readings(), sensor.info.path,
               simulation.read(sensor.info.path).value_or(std::vector<double>()));
  }
  for (const simcore::Port& port : simulation.ports()) {
    if (port.isActuator() && read_.contains(port.info.path))
      addReading(*message->mutable_readings(), port.info.path,
                 simulation.read(port.info.path).value_or(std::vector<double>()));
  }
  addOutputs(*message);
  addTruth(*message);
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
  const auto isDue = [this](robotlink::Duration period) {
    return world_.simulation().time() % period < SimulatedWorld::kStep;
  };
  const auto sensors = world_.simulation().imageSensors();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const std::string& path = sensors[i].info.path;
    const auto period = sensors[i].period.count() > 0 ? sensors[i].period : kUsualPeriod;
    if (!read_.contains(path) || !(all || isDue(period))) continue;
    images.push_back(
        {path, world_.clock().now(), measuredImage(world_.simulation(), i, world_.clock().now())});
  }
  for (const auto* output : world_.simulation().outputs()) {
    const std::string& path = output->info.path;
    if (output->kind != simcore::ControllerOutput::Kind::kImage || !read_.contains(path)) continue;
    // The images are sent as often as those of cameras.
    if (!all && !isDue(kUsualPeriod)) continue;
    auto image = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*image, output->image.view(), world_.clock().now(), path);
    images.push_back({path, world_.clock().now(), std::move(image)});
  }
  return images;
}

}  // namespace app
