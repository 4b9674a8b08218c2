// SPDX-License-Identifier: GPL-3.0-or-later
// readCamera(), readFacettes() and depthOfColorCamera() of SdfDevices.h: sensors that yield images.
#include <cmath>
#include <sstream>

#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

using ImageKind = ImageGeometry::Kind;

// Facettes of a sensor in each direction.
constexpr int kMaxFacettes = 4096;
constexpr double kUsualRate = 25;  // Hz, of cameras
/// Numbers in an image: as many as the largest depth image has pixels.
constexpr double kMaxImageValues = 8192.0 * 8192.0;

/// An image of radiation classes has one channel for each.
void checkImageSize(const ImageGeometry& image, const sdf::ElementPtr& element, const SdfContext& context) {
  const double pixels = static_cast<double>(image.camera.width) * image.camera.height;
  context.within(pixels * static_cast<double>(image.classes.size()), 0, kMaxImageValues,
                 "an image's width times its height times its classes", element);
}

/// Whether each place of the image, except in its corners, is seen in one direction: from the center
/// outwards, what is seen farther out is shown farther out until the edges are reached.
bool isInvertible(const LensDistortion& lens, double horizontalAngle, double verticalAngle) {
  if (!lens.any()) return true;
  constexpr int kDirections = 32;
  constexpr double kStep = 0.005, kFarthest = 100;
  const double edge = std::tan(std::max(horizontalAngle, verticalAngle) / 2);
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * robotlink::kPi * i / kDirections, c = std::cos(angle), s = std::sin(angle);
    double before = 0;
    // Steps grow, so that far places are reached, too.
    for (double r = kStep; before < edge; r += kStep * std::max(1.0, r)) {
      const double radial = 1 + r * r * (lens.k1 + r * r * (lens.k2 + r * r * lens.k3));
      const double tangential = 3 * r * (lens.p1 * s + lens.p2 * c);
      const double shown = r * (radial + tangential);
      if (!(shown > before) || r > kFarthest) return false;
      before = shown;
    }
  }
  return true;
}

/// The nearest and the farthest distance that a camera sees.
void checkClip(const sdf::Sensor& sensor, const sdf::ElementPtr& element, const SdfContext& context) {
  const sdf::Camera& camera = *sensor.CameraSensor();
  const sdf::ElementPtr clip = descendant(element, {"clip"}),
                        ofDepth = descendant(element, {"depth_camera", "clip"});
  const auto check = [&](double near, double far, const sdf::ElementPtr& at) {
    if (near >= 0 && near < far) return;
    context.fail(at, "scene.range", "<near> of <clip> must be at least 0 and below its <far>");
  };
  if (clip) check(camera.NearClip(), camera.FarClip(), clip);
  if (ofDepth && (camera.HasDepthNearClip() || camera.HasDepthFarClip())) {
    check(camera.HasDepthNearClip() ? camera.DepthNearClip() : camera.NearClip(),
          camera.HasDepthFarClip() ? camera.DepthFarClip() : camera.FarClip(), ofDepth);
  }
}

void readLens(const sdf::Camera& camera, const sdf::ElementPtr& element, SensorDescription& result,
              const SdfContext& context) {
  const auto share = [&](const char* name) { return ownNumber(element, name, 0, 0, 1, context); };
  result.vignetting = {share("vignetting"), share("vignetting_tint")};
  const auto coefficient = [&](double value, const char* name) {
    return context.within(value, -10, 10, name, element);
  };
  result.distortion = {coefficient(camera.DistortionK1(), "k1"), coefficient(camera.DistortionK2(), "k2"),
                       coefficient(camera.DistortionK3(), "k3"), coefficient(camera.DistortionP1(), "p1"),
                       coefficient(camera.DistortionP2(), "p2")};
  if (!isInvertible(result.distortion, result.horizontalAngle, result.verticalAngle)) {
    context.fail(
        element, "scene.camera",
        "no lens has this <distortion>: at the edges of the image, different directions would have the "
        "same place");
  }
  const ignition::math::Vector2d center = camera.DistortionCenter();
  if (result.distortion.any() && (center - ignition::math::Vector2d(0.5, 0.5)).Length() > 1e-6) {
    context.omit(element, "<center> of <distortion>", "it is the image's center");
  }
  result.shutter = {ownNumber(element, "exposure", 0, 0, ShutterModel::kMaxTime, context),
                    ownNumber(element, "readout", 0, 0, ShutterModel::kMaxTime, context)};
}

/// Makes an image sensor of a camera that was read.
void becomeImage(ImageKind kind, const sdf::Camera& camera, SensorDescription& result) {
  result.kind = SensorDescription::Kind::kImage;
  result.image.kind = kind;
  result.image.camera = {result.width, result.height, result.horizontalAngle, result.verticalAngle, {}, {}};
  if (kind != ImageKind::kDepth) return;
  result.image.nearest = camera.HasDepthNearClip() ? camera.DepthNearClip() : camera.NearClip();
  result.image.farthest = camera.HasDepthFarClip() ? camera.DepthFarClip() : camera.FarClip();
}

}  // namespace

void readCamera(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::Camera& camera = *sensor.CameraSensor();
  const sdf::ElementPtr element = sensor.Element()->GetElement("camera");
  result.kind = SensorDescription::Kind::kCamera;
  result.width = static_cast<int>(context.within(camera.ImageWidth(), 2, 8192, "an image's width", element));
  result.height =
      static_cast<int>(context.within(camera.ImageHeight(), 2, 8192, "an image's height", element));
  result.horizontalAngle =
      context.within(camera.HorizontalFov().Radian(), 0.01, 3, "horizontal_fov", element);
  // Without a rate, or with 0, cameras of other simulators are as fast as these are.
  result.rate = sensor.UpdateRate() > 0 ? updateRate(sensor, 0.1, context) : kUsualRate;
  result.errors.noise = {readNoise(camera.ImageNoise(), 100, element, context)};
  result.verticalAngle = 2 * std::atan(std::tan(result.horizontalAngle / 2) * result.height / result.width);
  result.verticalAngle = ownNumber(element, "vertical_fov", result.verticalAngle, 0.01, 3, context);
  checkClip(sensor, element, context);
  readLens(camera, element, result, context);
  result.image.classes = ownTexts(element, "class");
  if (sensor.Type() == sdf::SensorType::DEPTH_CAMERA) becomeImage(ImageKind::kDepth, camera, result);
  if (sensor.Type() == sdf::SensorType::SEGMENTATION_CAMERA) becomeImage(ImageKind::kLabels, camera, result);
  if (sensor.Type() == sdf::SensorType::CAMERA && !result.image.classes.empty()) {
    becomeImage(ImageKind::kRadiation, camera, result);
  }
  const bool hidesMore = camera.NearClip() > 0.1 || camera.FarClip() < 100;
  if (sensor.Type() == sdf::SensorType::CAMERA && hidesMore && descendant(element, {"clip"}))
    context.omit(element->GetElement("clip"), "<clip> of a camera", "color cameras see at any distance");
  const bool takesClasses =
      result.kind == SensorDescription::Kind::kImage && result.image.kind == ImageKind::kRadiation;
  if (!takesClasses) result.image.classes.clear();
  checkImageSize(result.image, element, context);
  if (result.kind == SensorDescription::Kind::kImage && (result.distortion.any() || result.shutter.any())) {
    context.fail(element, "scene.camera",
                 "only color cameras can have a distortion, an exposure and a readout");
  }
}

std::vector<SensorDescription> depthOfColorCamera(const sdf::Sensor& sensor, const SensorDescription& color) {
  if (sensor.Type() != sdf::SensorType::RGBD_CAMERA) return {};
  SensorDescription depth = color;
  // The noise that SDFormat describes is that of colors.
  depth.errors.noise.clear();
  becomeImage(ImageKind::kDepth, *sensor.CameraSensor(), depth);
  return {depth};
}

void readFacettes(const sdf::ElementPtr& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::ElementPtr element = sensor->GetElement("robotcontrol:facette");
  ImageGeometry& image = result.image;
  result.kind = SensorDescription::Kind::kImage;
  image.kind = ImageKind::kFacette;
  const auto range = [&](const char* name, double most, double& start, double& end) {
    double count = 0;
    std::istringstream(element->Get<std::string>(std::string("robotcontrol:") + name)) >> start >> end >>
        count;
    start = context.within(start, -most, most, name, element);
    end = context.within(end, -most, most, name, element);
    return static_cast<int>(
        context.within(count, 1, kMaxFacettes, std::string("the number of facettes of ") + name, element));
  };
  for (const char* name : {"robotcontrol:azimuth", "robotcontrol:elevation"}) {
    if (element->HasElement(name)) continue;
    return context.fail(element, "scene.facette",
                        "a facette camera needs <robotcontrol:azimuth> and <robotcontrol:elevation>: the "
                        "first and the last angle, and the number of facettes");
  }
  image.camera.width = range("azimuth", robotlink::kPi, image.azimuthStart, image.azimuthEnd);
  image.camera.height = range("elevation", robotlink::kPi / 2, image.elevationStart, image.elevationEnd);
  image.farthest = ownNumber(element, "far", 1000, 1e-3, 10'000, context);
  image.classes = ownTexts(element, "class");
  if (image.classes.empty()) image.classes = {"Y", "Cb", "Cr"};
  checkImageSize(image, element, context);
}

}  // namespace simcore
