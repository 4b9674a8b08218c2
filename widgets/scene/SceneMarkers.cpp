// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneMarkers.h"

#include <algorithm>
#include <cmath>

#include "robotcontrol/World.pb.h"
#include "robotlink/packages/Conversions.h"
#include "widgets/scene/MarkerShapes.h"
#include "widgets/scene/SceneObjects.h"
#include "widgets/scene/render/MeshBuilder.h"
#include "widgets/world/SceneState.h"

namespace widgets {
namespace {

using robotcontrol::WorldObject;
using robotlink::Pose3;
using robotlink::Vector3;

constexpr MarkerColor kAxisColor{250, 205, 40, 255}, kFixedColor{150, 150, 150, 255},
    kCenterColor{205, 80, 225, 255};
constexpr double kSizePerCubeRoot = 0.05;  // m for 1 kg

std::string textOf(const WorldObject& object, const char* name) {
  for (const auto& property : object.properties())
    if (property.name() == name) return property.text();
  return {};
}

std::optional<Pose3> poseOf(const WorldObject& object, const SceneState& scene) {
  if (!object.has_pose_in_frame()) return std::nullopt;
  const auto frame = scene.framePose(object.frame());
  if (!frame) return std::nullopt;
  return Pose3(*frame * robotlink::pose3(object.pose_in_frame()));
}

/// Calls `found` with the objects of some kinds that are shown and have a place.
template <typename Found>
void forEachPlaced(const SceneObjects& objects, const SceneState& scene, const ObjectFilter& isShown,
                   std::initializer_list<WorldObject::Kind> kinds, std::size_t limit, Found found) {
  if (objects.all() == nullptr) return;
  std::size_t count = 0;
  for (const WorldObject& object : objects.all()->objects()) {
    if (std::ranges::find(kinds, object.kind()) == kinds.end() || !isShown(object.path())) continue;
    const auto pose = poseOf(object, scene);
    if (!pose) continue;
    if (++count > limit) return;
    found(object, *pose);
  }
}

SceneLabel nameLabel(const WorldObject& object, const Pose3& pose) {
  return {pose.translation(), QString::fromStdString(object.name()), Qt::white, 11, true};
}

}  // namespace

double SceneMarkers::sizeFor(const SceneObjects& objects, const std::string& model) {
  const auto* object = objects.find(model);
  const double mass = object == nullptr ? 1 : numberOf(*object, "mass").value_or(1);
  return std::clamp(kSizePerCubeRoot * std::cbrt(std::max(0.0, mass)), 0.03, 0.3);
}

const SceneMarkers::Shape& SceneMarkers::shape(Kind kind, double size) {
  const int millimeters = std::clamp(static_cast<int>(std::lround(size * 1000)), 2, 1000);
  Shape& known = shapes_[{kind, millimeters}];
  if (known) return known;
  const double s = millimeters / 1000.0;
  SceneShape made;
  MeshBuilder builder(made.opaque);
  const Pose3 origin = Pose3::Identity();
  switch (kind) {
    case Kind::kAxis:
      addMarkerArrow(made, {0, 0, -0.6 * s}, {0, 0, s}, s / 24, kAxisColor);
      builder.cylinder(origin, {s / 2, s / 2, s / 20}, 1, 1, kAxisColor);
      break;
    case Kind::kSlide:
      addMarkerArrow(made, {0, 0, 0}, {0, 0, s}, s / 24, kAxisColor);
      addMarkerArrow(made, {0, 0, 0}, {0, 0, -s}, s / 24, kAxisColor);
      break;
    case Kind::kBall:
      builder.sphere(origin, Vector3::Constant(s / 2), kAxisColor);
      break;
    case Kind::kFixed:
      builder.box(origin, Vector3::Constant(s / 4), kFixedColor);
      break;
    case Kind::kFrame:
      addMarkerAxes(made, s);
      break;
    case Kind::kCenter:
      builder.sphere(origin, Vector3::Constant(s), kCenterColor);
      break;
  }
  known = std::make_shared<const SceneShape>(std::move(made));
  return known;
}

void SceneMarkers::addJoint(const WorldObject& joint, const Pose3& inField, double size,
                            std::vector<SceneBody>& bodies) {
  const std::string type = textOf(joint, "type");
  const auto axis = vectorOf(joint, "axis_in_link");
  if (!axis) {
    bodies.push_back({shape(type == "ball" ? Kind::kBall : Kind::kFixed, size), inField, {}});
    return;
  }
  const Pose3 along = inField * poseAlong(Vector3::Zero(), *axis);
  bodies.push_back({shape(type == "prismatic" ? Kind::kSlide : Kind::kAxis, size), along, {}});
}

std::vector<SceneBody> SceneMarkers::joints(const SceneObjects& objects, const SceneState& scene,
                                            const ObjectFilter& isShown) {
  std::vector<SceneBody> bodies;
  forEachPlaced(objects, scene, isShown, {WorldObject::JOINT}, kMaxMarkers,
                [&](const WorldObject& joint, const Pose3& pose) {
                  addJoint(joint, pose, sizeFor(objects, joint.model()), bodies);
                });
  return bodies;
}

std::vector<SceneBody> SceneMarkers::frames(const SceneObjects& objects, const SceneState& scene,
                                            const ObjectFilter& isShown) {
  std::vector<SceneBody> bodies;
  forEachPlaced(objects, scene, isShown,
                {WorldObject::ROBOT, WorldObject::BALL, WorldObject::MODEL, WorldObject::LINK}, kMaxMarkers,
                [&](const WorldObject& object, const Pose3& pose) {
                  const double share = object.kind() == WorldObject::LINK ? 1 : 1.6;
                  bodies.push_back({shape(Kind::kFrame, share * sizeFor(objects, object.model())), pose, {}});
                });
  return bodies;
}

std::vector<SceneBody> SceneMarkers::centers(const SceneObjects& objects, const SceneState& scene,
                                             const ObjectFilter& isShown) {
  constexpr double kDiameterPerCubeRoot = 0.035;  // m for 1 kg
  std::vector<SceneBody> bodies;
  forEachPlaced(
      objects, scene, isShown, {WorldObject::LINK}, kMaxMarkers,
      [&](const WorldObject& link, const Pose3& pose) {
        const auto center = vectorOf(link, "center_of_mass");
        if (!center) return;
        const double mass = numberOf(link, "mass").value_or(0);
        const double size = std::clamp(kDiameterPerCubeRoot * std::cbrt(std::max(0.0, mass)), 0.006, 0.2);
        bodies.push_back({shape(Kind::kCenter, size), Pose3(pose * Eigen::Translation3d(*center)), {}});
      });
  return bodies;
}

std::vector<SceneLabel> jointNames(const SceneObjects& objects, const SceneState& scene,
                                   const ObjectFilter& isNamed) {
  std::vector<SceneLabel> labels;
  forEachPlaced(
      objects, scene, isNamed, {WorldObject::JOINT}, kMaxNames,
      [&](const WorldObject& joint, const Pose3& pose) { labels.push_back(nameLabel(joint, pose)); });
  return labels;
}

std::vector<SceneLabel> modelNames(const SceneObjects& objects, const SceneState& scene,
                                   const ObjectFilter& isNamed) {
  std::vector<SceneLabel> labels;
  forEachPlaced(
      objects, scene, isNamed, {WorldObject::MODEL, WorldObject::BALL}, kMaxNames,
      [&](const WorldObject& model, const Pose3& pose) { labels.push_back(nameLabel(model, pose)); });
  return labels;
}

}  // namespace widgets
