// SPDX-License-Identifier: GPL-3.0-or-later
// Simulation: readings of range and image sensors, in several threads if there are any, and camera images.
#include "simcore/Simulation.h"
#include "simcore/SimulationState.h"

namespace simcore {

void SimulationState::prepareToMeasureAhead() {
  std::vector<std::size_t> ranges, images;
  for (const RangeSensor& sensor : ports.ranges) ranges.push_back(static_cast<std::size_t>(sensor.readings));
  for (const ImageSensor& sensor : ports.images) images.push_back(sensor.values());
  rangesAhead.emplace(options.pool, ranges);
  imagesAhead.emplace(options.pool, images);
  otherImaging.clear();
  for (std::size_t i = 1; imaging && i < std::min(imagesAhead->lanes(), ports.images.size()); ++i) {
    otherImaging.push_back(
        std::make_unique<ImageSensing>(scene->contents().renderScene, ports.images, ports.imageOwners));
  }
}

void SimulationState::poseRanging(std::uint64_t step) {
  if (!rangingValid || rangingStep != step) ranging->setPoses(posesAt(step));
  rangingValid = true;
  rangingStep = step;
}

void SimulationState::poseImaging(std::uint64_t step) {
  if (!imagingValid || imagingStep != step) {
    const auto present = posesAt(step);
    imaging->setPoses(present);
    for (const auto& other : otherImaging) other->setPoses(present);
  }
  imagingValid = true;
  imagingStep = step;
}

void SimulationState::measure(std::size_t sensor, std::span<double> ranges) {
  const std::uint64_t step = stepOf(rangeTiming[sensor]);
  poseRanging(step);
  if (step != steps) return ranging->measure(sensor, {options.noise, options.seed, step}, ranges);
  rangesAhead->read(
      sensor, steps, [this](std::size_t other) { return stepOf(rangeTiming[other]) == steps; },
      [this](std::size_t, std::size_t one, std::span<double> values) {
        ranging->measure(one, noise(), values);
      },
      ranges);
}

void SimulationState::measureImage(std::size_t sensor, std::span<float> values) {
  const std::uint64_t step = stepOf(imageTiming[sensor]);
  poseImaging(step);
  if (step != steps) return imaging->measure(sensor, {options.noise, options.seed, step}, values);
  imagesAhead->read(
      sensor, steps, [this](std::size_t other) { return stepOf(imageTiming[other]) == steps; },
      [this](std::size_t lane, std::size_t one, std::span<float> image) {
        ImageSensing& own = lane == 0 ? *imaging : *otherImaging[lane - 1];
        own.measure(one, noise(), image);
      },
      values);
}

void SimulationState::setImageErrors(std::size_t sensor, const SensorErrors& errors) {
  const ImageSensing::Noise noise{true, options.seed, steps};
  imaging->setErrors(sensor, errors, noise);
  for (const auto& other : otherImaging) other->setErrors(sensor, errors, noise);
}

const robotlink::Image& Simulation::cameraImage(std::size_t camera) const {
  Implementation& i = *implementation_;
  if (const robotlink::Image* made = cameraImages_ ? cameraImages_(camera) : nullptr) return *made;
  if (!i.renderer) i.renderer = std::make_unique<CameraRenderer>(renderScene(), CameraRenderer::Options{});
  i.optics.resize(i.ports.cameras.size());
  const CameraSensor& sensor = i.ports.cameras[camera];
  const ImageNoise noise{i.options.noise || i.cameraTiming[camera].chosen ? sensor.noise : 0, i.options.seed,
                         hashOfPath(sensor.info.path), cameraStep(camera)};
  const auto posesAt = [&](double age, std::vector<Pose3>& poses) { cameraPoses(camera, age, poses); };
  i.optics[camera].render(*i.renderer, posesAt, {sensor.body, sensor.cameraInBody}, sensor.model,
                          sensor.shutter, robotlink::PixelFormat::kYuyv, noise, i.cameraImage);
  return i.cameraImage;
}

}  // namespace simcore
