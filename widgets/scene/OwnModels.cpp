// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/OwnModels.h"

#include <QCoreApplication>
#include <algorithm>

#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/scene/SensorShapes.h"
#include "widgets/scene/render/MeshBuilder.h"
#include "widgets/scene/render/SceneShapes.h"
#include "widgets/world/SceneState.h"
#include "widgets/world/WorldDrawings.h"

namespace widgets {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;

constexpr double kBesideEachOther = 0.7;  // m
constexpr double kFloorThickness = 0.02;  // m
constexpr double kNameHeight = 0.4;       // m
constexpr MeshBuilder::Color kFloorColor{150, 152, 155, 255};

bool isInScene(const SceneState& scene, const std::string& robot) {
  return std::ranges::any_of(scene.items(), [&](const auto& item) { return item.second.model == robot; });
}

const robotlink::RobotDescription* descriptionOf(const ViewContext& context, const std::string& robot) {
  const auto found = context.robots.find(robot);
  return found == context.robots.end() ? nullptr : found->second.get();
}

}  // namespace

const OwnModels::Model* OwnModels::modelOf(const ViewContext& context, const std::string& kind,
                                           const QColor& team) {
  const auto [found, isNew] = models_.try_emplace({kind, team.rgb()});
  Model& model = found->second;
  if (isNew && context.bodyOf) model.body = context.bodyOf(kind, team);
  if (isNew && model.body && model.body->shapes) {
    for (const auto& entity : model.body->shapes->entities())
      model.shapes.push_back(std::make_shared<const SceneShape>(shapeOf(entity)));
  }
  return model.body ? &model : nullptr;
}

void OwnModels::update(const ViewContext& context, const SceneState& scene,
                       const std::vector<RobotBelief>& beliefs, robotlink::Instant shown) {
  std::map<std::string, Robot> robots;
  robotlink::Session& session = context.session;
  for (const RobotBelief& belief : beliefs) {
    const auto* description = descriptionOf(context, belief.robot);
    if (description == nullptr || isInScene(scene, belief.robot)) continue;
    const auto pose = belief.drawingPose();
    // A view that asks for a certain pose does not want to see the remote robot.
    if (!pose && belief.isPlaced) continue;
    const Model* model = modelOf(context, description->name, belief.team);
    if (model == nullptr) continue;
    subscription_.want(session, belief.robot,
                       {robotlink::kJointStates.name, robotlink::kRobotPose.name, robotlink::kCameraPose.name,
                        robotlink::kBodySensors.name, robotlink::kSonar.name, robotlink::kLaser.name,
                        robotlink::kDriveState.name});
    const auto before = robots_.find(belief.robot);
    Robot robot = before == robots_.end() || before->second.model != model ? Robot() : before->second;
    robot.name = belief.robot;
    robot.model = model;
    robot.isPoseKnown = pose.has_value();
    robot.isTruthKnown = belief.truth.has_value();
    const double aside = -kBesideEachOther * static_cast<double>(robots.size());
    robot.inField = poseOnGround(pose ? *pose : robotlink::Pose2{0, aside, 0});
    readJoints(session.store(), shown, robot);
    readSensors(session.store(), shown, description, robot);
    robots.emplace(robot.name, std::move(robot));
  }
  robots_ = std::move(robots);
}

void OwnModels::readJoints(const robotlink::StreamStore& store, robotlink::Instant shown, Robot& robot) {
  const auto* message = store.latest(robot.name + '/' + robotlink::kJointStates.name, shown);
  const robotlink::PackagePtr value = message == nullptr ? nullptr : message->value;
  if (!robot.parts.empty() && value == robot.joints) return;
  robot.joints = value;
  JointAngles angles;
  if (const auto* states = dynamic_cast<const foxglove::JointStates*>(value.get())) {
    for (const auto& joint : states->joints()) {
      if (joint.has_position()) angles[joint.name()] = joint.position();
    }
  }
  robot.parts = partsOnGround(*robot.model->body, angles);
}

void OwnModels::readSensors(const robotlink::StreamStore& store, robotlink::Instant shown,
                            const robotlink::RobotDescription* description, Robot& robot) {
  SceneLines lines = sensorLines(store, robot.name, description, shown);
  if (robot.sensors && areSame(robot.sensors->lines, lines)) return;
  auto shape = std::make_shared<SceneShape>();
  shape->lines = std::move(lines);
  robot.sensors = std::move(shape);
}

void OwnModels::makeFloor(const SceneBox& ground) {
  if (floor_ && floorBox_ == ground) return;
  auto shape = std::make_shared<SceneShape>();
  Pose3 middle = Pose3::Identity();
  middle.translation() = Vector3(ground.center.x(), ground.center.y(), -kFloorThickness / 2);
  MeshBuilder(shape->opaque).box(middle, {ground.size.x(), ground.size.y(), kFloorThickness}, kFloorColor);
  floor_ = std::move(shape);
  floorBox_ = ground;
}

std::vector<SceneBody> OwnModels::bodies(const std::optional<SceneBox>& ground) {
  std::vector<SceneBody> bodies;
  if (robots_.empty()) return bodies;
  if (ground) {
    makeFloor(*ground);
    bodies.push_back({floor_, Pose3::Identity(), {}});
  }
  for (const auto& [name, robot] : robots_) {
    for (std::size_t i = 0; i < std::min(robot.parts.size(), robot.model->shapes.size()); ++i)
      bodies.push_back({robot.model->shapes[i], robot.inField * robot.parts[i], name});
  }
  return bodies;
}

std::vector<SceneBody> OwnModels::sensors() const {
  std::vector<SceneBody> bodies;
  for (const auto& [name, robot] : robots_) {
    if (!robot.sensors->lines.segments.empty()) bodies.push_back({robot.sensors, robot.inField, {}});
  }
  return bodies;
}

std::vector<SceneLabel> OwnModels::names() const {
  std::vector<SceneLabel> labels;
  for (const auto& [name, robot] : robots_) {
    if (robot.isTruthKnown) continue;
    const QString shown = QString::fromStdString(name);
    labels.push_back(
        {robot.inField * Vector3(0, 0, kNameHeight),
         robot.isPoseKnown ? shown : QCoreApplication::translate("OwnModels", "%1 (pose unknown)").arg(shown),
         Qt::white, 11, true});
  }
  return labels;
}

}  // namespace widgets
