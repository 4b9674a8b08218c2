// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "simcore/noise/NoiseProcess.h"
#include "simcore/ranging/RadiationLight.h"
#include "simcore/rendering/CameraRenderer.h"
#include "simcore/rendering/RayCaster.h"
#include "simcore/world/ImageSensor.h"

namespace simcore {

class StateStream;

/// Computes the images of depth and class cameras, of facette cameras, and of cameras that sense radiation.
/// Their noise depends only on seed, sensor and step, so it does not matter how often, or whether, images are
/// requested. Its parts are created on first use. One thread at a time.
class ImageSensing {
 public:
  /// `own[i]` are the bodies of the model that carries sensors[i]. `sensors` must outlive it.
  ImageSensing(std::shared_ptr<const RenderScene> scene, const std::vector<ImageSensor>& sensors,
               std::vector<RayCaster::BodyRange> own);
  ~ImageSensing();

  /// Sets the present poses of the bodies, by body index of the scene. They must stay valid until the last
  /// measure().
  void setPoses(std::span<const Pose3> bodyInWorld);
  using Noise = NoiseSelection;
  /// Replaces the noise of a sensor from this step on, and applies it even where noise is off.
  void setErrors(std::size_t sensor, const SensorErrors& errors, const Noise& noise);
  /// Writes or reads the errors of all sensors and what has drifted; `noise` is that of the present step.
  void transfer(StateStream& stream, const Noise& noise);
  /// Writes the image of a sensor, row by row, with the channels of a pixel side by side; values.size() must
  /// be ImageSensor::values().
  void measure(std::size_t sensor, const Noise& noise, std::span<float> values);

 private:
  void measureDepth(const ImageSensor& sensor, const Pose3& pose, std::span<float> values);
  void measureLabels(const ImageSensor& sensor, const Pose3& pose, std::span<float> values);
  void measureRadiation(std::size_t index, const Pose3& pose, std::span<float> values);
  CameraRenderer& renderer();
  RayCaster& caster();
  RadiationLight& light();
  const RayBundle& bundle(std::size_t sensor);

  std::shared_ptr<const RenderScene> scene_;
  const std::vector<ImageSensor>& sensors_;
  std::vector<RayCaster::BodyRange> own_;
  std::span<const Pose3> poses_;
  /// Made when they are needed, and whether they have the present poses.
  std::unique_ptr<CameraRenderer> renderer_;
  std::unique_ptr<RayCaster> caster_;
  std::unique_ptr<RadiationLight> light_;
  bool rendererPosed_ = false, casterPosed_ = false, lightPosed_ = false;
  /// Keyed by sensor.
  std::vector<std::optional<RayBundle>> bundles_;
  std::vector<NoiseProcess> noise_;
  std::vector<bool> chosen_;
  /// Keyed by instance.
  std::vector<float> labels_;
  // Buffers.
  std::vector<BundleHit> hits_;
  std::vector<double> noisy_;
};

/// The directions of the facettes, or of the pixels' centers, row by row, in the frame of the sensor.
RayBundle bundleOf(const ImageGeometry& geometry);

}  // namespace simcore
