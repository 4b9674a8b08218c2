// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules/perception/FieldCamera.h"

#include <stdexcept>

namespace modules {

using robotlink::Pose3;

namespace {

/// Read once: reading takes longer than all images of a test.
const std::shared_ptr<const simcore::Scene>& fieldScene() {
  static const auto scene = simcore::Scene::load(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf");
  if (!scene) throw std::runtime_error(describe(scene.error()));
  return *scene;
}

}  // namespace

FieldCamera::FieldCamera() {
  auto field = robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml");
  if (!field) throw std::runtime_error(describe(field.error()));
  field_ = *field;
  classes_ = fieldClasses(field_);
  table_ = fieldColorTable(field_, classes_, {});
  auto simulation = simcore::Simulation::create(fieldScene(), {});
  if (!simulation) throw std::runtime_error(simulation.error().describe());
  simulation_ = *std::move(simulation);
  scene_ = simulation_->renderScene();
  poses_.assign(simulation_->bodyPoses().begin(), simulation_->bodyPoses().end());
  renderer_ = std::make_unique<simcore::CameraRenderer>(scene_, simcore::CameraRenderer::Options{});
  putRobot({0, 50, 0});
}

std::size_t FieldCamera::body(const std::string& name) const {
  for (std::size_t i = 0; i < scene_->bodies.size(); ++i)
    if (scene_->bodies[i].starts_with(name)) return i;
  throw std::runtime_error("no body " + name);
}

void FieldCamera::putBall(const robotlink::Vector2& place, double height) {
  poses_[body("ball")] = Pose3(Eigen::Translation3d(place.x(), place.y(), height));
}

void FieldCamera::putRobot(const robotlink::Pose2& place) {
  const Pose3 before = *simulation_->modelPose("red1");
  const Pose3 after = Pose3(Eigen::Translation3d(place.x, place.y, before.translation().z())) *
                      Pose3(Eigen::AngleAxisd(place.heading, Eigen::Vector3d::UnitZ()));
  for (std::size_t i = 0; i < poses_.size(); ++i)
    if (scene_->bodies[i].starts_with("red1"))
      poses_[i] = after * before.inverse() * simulation_->bodyPoses()[i];
}

CameraView FieldCamera::view(const NeckAngles& neck) {
  CameraView view;
  view.cameraInRobot = BodyTilt{0.1136, 0, 0}.bodyInRobot() * cameraInBody(RobotDimensions{}, neck);
  return view;
}

const robotlink::Image& FieldCamera::look(const robotlink::Pose2& robotInField, const CameraView& view) {
  const Pose3 robot = Pose3(Eigen::Translation3d(robotInField.x, robotInField.y, 0)) *
                      Pose3(Eigen::AngleAxisd(robotInField.heading, Eigen::Vector3d::UnitZ()));
  renderer_->setPoses(poses_);
  const simcore::CameraSensor& camera = simulation_->cameras().front();
  renderer_->render(robot * view.cameraInRobot, {}, robotlink::PixelFormat::kYuyv,
                    {camera.noise, 1, 1, ++frame_}, image_);
  return image_;
}

std::vector<colortool::Region> FieldCamera::regions(std::string_view className) {
  robotlink::Image classImage;
  table_.classify(image_.view(), classImage);
  colortool::RegionFinder finder({});
  std::vector<colortool::Region> all = finder.findInRows(classImage.view());
  if (!className.empty())
    std::erase_if(all, [&](const auto& region) { return region.colorClass != classes_.index(className); });
  return all;
}

}  // namespace modules
