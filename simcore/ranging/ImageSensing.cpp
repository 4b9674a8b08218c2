// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/ranging/ImageSensing.h"

#include <cmath>
#include <limits>

#include "simcore/physics/Step.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// Separates these random numbers from those of other sensors.
constexpr std::uint64_t kImageStream = 0x696D616765;

using ImageKind = ImageGeometry::Kind;

Eigen::Vector3d facette(const ImageGeometry& geometry, int row, int column) {
  const auto between = [](double start, double end, int i, int count) {
    return count > 1 ? start + (end - start) * i / (count - 1) : (start + end) / 2;
  };
  const double azimuth = between(geometry.azimuthStart, geometry.azimuthEnd, column, geometry.camera.width);
  const double elevation =
      between(geometry.elevationStart, geometry.elevationEnd, row, geometry.camera.height);
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

Eigen::Vector3d pixel(const CameraModel& camera, int row, int column) {
  const double x = (column + 0.5) / camera.width * 2 - 1, y = (row + 0.5) / camera.height * 2 - 1;
  return {1, -x * std::tan(camera.horizontalAngle / 2), -y * std::tan(camera.verticalAngle / 2)};
}

}  // namespace

RayBundle bundleOf(const ImageGeometry& geometry) {
  std::vector<Eigen::Vector3d> directions;
  const CameraModel& camera = geometry.camera;
  directions.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      directions.push_back(geometry.kind == ImageKind::kFacette ? facette(geometry, row, column)
                                                                : pixel(camera, row, column));
    }
  }
  return {camera.height, camera.width, directions};
}

ImageSensing::ImageSensing(std::shared_ptr<const RenderScene> scene, const std::vector<ImageSensor>& sensors,
                           std::vector<RayCaster::BodyRange> own)
    : scene_(std::move(scene)),
      sensors_(sensors),
      own_(std::move(own)),
      bundles_(sensors.size()),
      chosen_(sensors.size()),
      labels_(scene_->labels.begin(), scene_->labels.end()) {
  for (const ImageSensor& sensor : sensors_) {
    noise_.emplace_back(NoiseProcess::Stream{kImageStream, noise_.size()}, 1, kStepSeconds,
                        sensor.errors.noise);
  }
}

ImageSensing::~ImageSensing() = default;

void ImageSensing::setPoses(std::span<const Pose3> bodyInWorld) {
  poses_ = bodyInWorld;
  rendererPosed_ = casterPosed_ = lightPosed_ = false;
}

CameraRenderer& ImageSensing::renderer() {
  if (!renderer_) {
    renderer_ = std::make_unique<CameraRenderer>(scene_, CameraRenderer::Options{.shadows = false});
  }
  if (!rendererPosed_) renderer_->setPoses(poses_);
  rendererPosed_ = true;
  return *renderer_;
}

RayCaster& ImageSensing::caster() {
  if (!caster_) caster_ = std::make_unique<RayCaster>(scene_);
  if (!casterPosed_) caster_->setPoses(poses_);
  casterPosed_ = true;
  return *caster_;
}

RadiationLight& ImageSensing::light() {
  if (!light_) light_ = std::make_unique<RadiationLight>(scene_);
  if (!lightPosed_) light_->setPoses(poses_);
  lightPosed_ = true;
  return *light_;
}

const RayBundle& ImageSensing::bundle(std::size_t sensor) {
  std::optional<RayBundle>& rays = bundles_[sensor];
  if (!rays) rays = bundleOf(sensors_[sensor].geometry);
  return *rays;
}

void ImageSensing::transfer(StateStream& stream, const Noise& noise) {
  for (NoiseProcess& process : noise_) process.transfer(stream, noise.seed, noise.step);
  stream.bits(chosen_);
}

void ImageSensing::setErrors(std::size_t sensor, const SensorErrors& errors, const Noise& noise) {
  noise_[sensor].change(errors.noise, noise.seed, noise.step);
  chosen_[sensor] = true;
}

void ImageSensing::measure(std::size_t index, const Noise& noise, std::span<float> values) {
  const ImageSensor& sensor = sensors_[index];
  const Pose3 pose = poses_[static_cast<std::size_t>(sensor.body)] * sensor.sensorInBody;
  if (sensor.geometry.kind == ImageKind::kLabels) return measureLabels(sensor, pose, values);
  if (sensor.geometry.kind == ImageKind::kDepth) {
    measureDepth(sensor, pose, values);
  } else {
    measureRadiation(index, pose, values);
  }
  if ((!noise.on && !chosen_[index]) || !noise_[index].any()) return;
  noisy_.assign(values.begin(), values.end());
  noise_[index].apply(noise.seed, noise.step, noisy_.data(), noisy_.size(),
                      [](double value) { return std::isfinite(value); });
  for (std::size_t i = 0; i < noisy_.size(); ++i) values[i] = static_cast<float>(noisy_[i]);
}

void ImageSensing::measureDepth(const ImageSensor& sensor, const Pose3& pose, std::span<float> values) {
  renderer().renderDepth(pose, sensor.geometry.camera, values);
  const auto nearest = static_cast<float>(sensor.geometry.nearest),
             farthest = static_cast<float>(sensor.geometry.farthest);
  for (float& depth : values) {
    depth = depth < nearest ? 0 : depth > farthest ? std::numeric_limits<float>::infinity() : depth;
  }
}

void ImageSensing::measureLabels(const ImageSensor& sensor, const Pose3& pose, std::span<float> values) {
  renderer().renderDepth(pose, sensor.geometry.camera, values);
  renderer().labelValues(labels_, 0, values);
}

void ImageSensing::measureRadiation(std::size_t index, const Pose3& pose, std::span<float> values) {
  const ImageSensor& sensor = sensors_[index];
  const RayBundle& rays = bundle(index);
  hits_.resize(rays.size());
  // A pinhole camera sees its own robot, as other cameras do.
  const RayCaster::BodyRange excluded =
      sensor.geometry.kind == ImageKind::kFacette ? own_[index] : RayCaster::BodyRange{};
  caster().castBundle(rays, pose, sensor.geometry.farthest, excluded, hits_);
  light().shade(rays, hits_, pose, sensor.geometry.classes, values);
}

}  // namespace simcore
