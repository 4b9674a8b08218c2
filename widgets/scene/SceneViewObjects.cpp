// SPDX-License-Identifier: GPL-3.0-or-later
// SceneView: single objects of the scene: how they are drawn, the camera that follows one, and their menus.
#include <QAction>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <set>

#include "robotcontrol/World.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "widgets/Icon.h"
#include "widgets/RobotChoice.h"
#include "widgets/scene/SceneCanvas.h"
#include "widgets/scene/SceneModes.h"
#include "widgets/scene/SceneView.h"
#include "widgets/world/SceneSelection.h"

namespace widgets {
namespace {

using robotlink::failure;
using robotlink::Pose3;
using robotlink::Result;

constexpr double kWheelsDistance = 4.5;  // m; distance from which a robot on wheels is seen well
constexpr double kRadiiAway = 3.4;       // distance from which an object fills most of the picture
constexpr double kEyeAngle = robotlink::radians(60);  // of objects that are no cameras

/// Roll, pitch and yaw, rad.
std::array<double, 3> anglesOf(const Eigen::Matrix3d& rotation) {
  const double pitch = std::asin(std::clamp(-rotation(2, 0), -1.0, 1.0));
  return {std::atan2(rotation(2, 1), rotation(2, 2)), pitch, std::atan2(rotation(1, 0), rotation(0, 0))};
}

}  // namespace

Result<void> SceneView::require(const std::string& path) const {
  if (parts_.objects().find(path) != nullptr || scene_.modelPose(path)) return {};
  return failure("scene.object",
                 parts_.objects().all() == nullptr
                     ? "there is no simulated scene, so there is no object " + path
                     : "the scene has no object " + path + "; the scene tree names them all",
                 {}, {path});
}

Result<void> SceneView::hideObject(const std::string& path) {
  if (const auto known = require(path); !known) return known;
  parts_.changeLooks().hide(path, parts_.objects());
  tick();
  return {};
}

Result<void> SceneView::showObject(const std::string& path) {
  if (path.empty()) {
    parts_.changeLooks().showAll();
  } else {
    if (const auto known = require(path); !known) return known;
    parts_.changeLooks().show(path, parts_.objects());
  }
  tick();
  return {};
}

Result<void> SceneView::drawObject(const std::string& path, const std::string& surface) {
  const auto wanted = surfaceNamed(surface);
  if (!wanted && (surface != "view" || path.empty()))
    return failure("scene.surface",
                   "surfaces are drawn shaded, flat, as hidden-lines or wire, not " + surface);
  if (path.empty()) {
    modes_->setSurface(*wanted);
    return {};
  }
  if (const auto known = require(path); !known) return known;
  parts_.changeLooks().setSurface(path, wanted);
  tick();
  return {};
}

Result<void> SceneView::setOpacity(const std::string& path, double opacity) {
  if (const auto known = require(path); !known) return known;
  if (!(opacity >= 0 && opacity <= 1))
    return failure("scene.opacity", "an opacity is from 0 (almost invisible) to 1");
  parts_.changeLooks().setOpacity(path, static_cast<float>(opacity));
  tick();
  return {};
}

Result<void> SceneView::showLayer(const std::string& layer, bool shown) {
  const auto named = layerNamed(layer);
  if (!named) return failure("scene.layer", "there is no layer " + layer);
  modes_->setShown(*named, shown);
  return {};
}

Result<void> SceneView::followObject(const std::string& path, Following how) {
  if (!path.empty())
    if (const auto known = require(path); !known) return known;
  if (how == Following::kOff) {
    letGo();
    return {};
  }
  followed_ = path;
  extent_.reset();
  ride_.forget();
  QAction* chosen = how == Following::kPosition  ? follow_
                    : how == Following::kHeading ? behind_
                                                 : firstPerson_;
  if (!chosen->isChecked()) chosen->setChecked(true);
  tick();
  return {};
}

Result<void> SceneView::showOnly(const std::string& path, bool alone) {
  if (path.empty()) {
    limitTo({});
    tick();
    return {};
  }
  if (const auto known = require(path); !known) return known;
  limitTo(alone ? path : std::string());
  return followObject(path, Following::kPosition);
}

std::vector<std::string> SceneView::objectPaths() const {
  std::vector<std::string> paths;
  if (const auto* all = parts_.objects().all())
    for (const auto& object : all->objects()) paths.push_back(object.path());
  return paths;
}

std::vector<std::string> SceneView::hiddenPaths() const {
  std::set<std::string> hidden;
  const auto& objects = parts_.objects();
  const std::vector<std::string> all =
      parts_.looks().hiddenCount() > 0 ? objectPaths() : std::vector<std::string>();
  for (const std::string& path : all) {
    if (!parts_.looks().isHidden(path, objects)) continue;
    for (const std::string& above : objects.lineage(path)) hidden.insert(above);
  }
  return {hidden.begin(), hidden.end()};
}

void SceneView::limitTo(const std::string& path) {
  if (path == parts_.only()) return;
  parts_.setOnly(path);
  Q_EMIT titleChanged(path.empty() ? tr("Scene") : tr("Scene: %1").arg(QString::fromStdString(path)));
}

std::optional<CameraRide::Subject> SceneView::subject() {
  if (!followed_.empty()) {
    const auto pose = parts_.objects().pose(followed_, scene_);
    if (!pose) return std::nullopt;
    constexpr double kUnknownRadius = 0.3;  // m, of what has no shape
    ShownParts::Extent extent{robotlink::Vector3::Zero(), kUnknownRadius};
    if (!extent_ && ride_.mode() != CameraRide::Mode::kOff && !scene_.items().empty())
      extent_ = parts_.extentOf(followed_, assembly_.bodies(scene_), scene_).value_or(extent);
    extent = extent_.value_or(extent);
    const robotlink::Vector3 middle = *pose * extent.middle;
    CameraRide::Subject subject{robotlink::groundPose(*pose), {}, middle.z()};
    subject.isObject = true;
    subject.robot.x = middle.x();
    subject.robot.y = middle.y();
    subject.distance = std::clamp(kRadiiAway * extent.radius, 2 * SceneCamera::kMinDistance, 100.0);
    return subject;
  }
  const auto pose = robotPose();
  if (!pose) return std::nullopt;
  CameraRide::Subject subject{*pose, {}};
  if (const auto ball = scene_.modelPose(kBallModel)) subject.ball = ball->translation().head<2>();
  const auto robot = context().robots.find(robots_->robot(session()));
  if (robot != context().robots.end() && robot->second && robot->second->drive)
    subject.distance = kWheelsDistance;
  return subject;
}

void SceneView::lookOut() {
  const std::string from = followed_.empty() ? robots_->robot(session()) : followed_;
  const auto* camera = parts_.objects().cameraOf(from);
  const auto pose = parts_.objects().pose(camera == nullptr ? from : camera->path(), scene_);
  if (!pose) return endLookingOut();
  if (!before_) before_ = canvas_->camera();
  SceneCamera eye = *before_;
  eye.eyeInField = pose->matrix();
  eye.verticalAngle = kEyeAngle;
  if (const auto angle = camera == nullptr ? std::nullopt : numberOf(*camera, "opening_angles", 1))
    eye.verticalAngle = std::clamp(*angle, robotlink::radians(5), robotlink::radians(150));
  canvas_->setCamera(eye);
}

void SceneView::endLookingOut() {
  if (!before_) return;
  canvas_->setCamera(*before_);
  before_.reset();
}

QMenu* SceneView::makeObjectMenu(const std::string& path, QWidget* parent) {
  auto* menu = new QMenu(QString::fromStdString(path), parent);
  menu->setObjectName(QStringLiteral("sceneObject:") + QString::fromStdString(path));
  const auto add = [&](QMenu* to, const char* name, const QString& text, auto done) {
    QAction* action = to->addAction(text, this, [done = std::move(done)] { (void)done(); });
    action->setObjectName(QLatin1String(name));
    return action;
  };
  add(menu, "sceneHide", tr("Hide"), [this, path] { return hideObject(path); })->setIcon(icon("clear"));
  add(menu, "sceneOnly", tr("Show alone"), [this, path] { return showOnly(path, true); });
  menu->addSeparator();
  using enum Following;
  add(menu, "sceneFollowObject", tr("Follow"), [this, path] {
    return followObject(path, kPosition);
  })->setIcon(icon("follow"));
  add(menu, "sceneTurnWith", tr("Follow and turn with it"), [this, path] {
    return followObject(path, kHeading);
  })->setIcon(icon("behind"));
  add(menu, "sceneLookOut", tr("First person"), [this, path] {
    return followObject(path, kFirstPerson);
  })->setIcon(icon("eye"));
  menu->addSeparator();
  QMenu* surfaces = menu->addMenu(tr("Drawn"));
  const std::array<std::pair<const char*, QString>, 5> kinds{
      {{"view", tr("As the view")},
       {"shaded", tr("Shaded")},
       {"flat", tr("Flat")},
       {"hidden-lines", tr("Edges, hidden ones left out")},
       {"wire", tr("Wire frame")}}};
  for (const auto& [kind, text] : kinds)
    add(surfaces, kind, text, [this, path, kind = std::string(kind)] { return drawObject(path, kind); });
  QMenu* opacities = menu->addMenu(tr("Seen through"));
  for (const int percent : {0, 25, 50, 75, 90})
    add(opacities, "sceneOpacity", percent == 0 ? tr("Not at all") : tr("%1 %").arg(percent),
        [this, path, percent] { return setOpacity(path, 1 - percent / 100.0); });
  return menu;
}

/// For the part below the mouse its link and its model are offered, which are what people see as one thing.
void SceneView::addObjectMenus(QMenu& menu, const std::string& path) {
  for (const std::string& each : parts_.objects().lineage(path)) {
    const auto* object = parts_.objects().find(each);
    using Object = robotcontrol::WorldObject;
    const bool isModel = each.find('/') == std::string::npos;
    if (isModel || (object != nullptr && object->kind() == Object::LINK)) {
      menu.addMenu(makeObjectMenu(each, &menu));
      if (isModel) return;
    }
  }
}

std::optional<QString> SceneView::numbers() {
  QString table = QStringLiteral("object\tx m\ty m\tz m\troll deg\tpitch deg\tyaw deg\n");
  const auto add = [&](const std::string& path, const Pose3& pose) {
    table += QString::fromStdString(path);
    for (int i = 0; i < 3; ++i) table += QLatin1Char('\t') + QString::number(pose.translation()[i], 'f', 4);
    for (const double angle : anglesOf(pose.linear()))
      table += QLatin1Char('\t') + QString::number(angle * 180 / robotlink::kPi, 'f', 2);
    table += QLatin1Char('\n');
  };
  const auto* all = parts_.objects().all();
  if (all == nullptr) {
    for (const std::string& model : scene_.models())
      if (const auto pose = scene_.modelPose(model)) add(model, *pose);
    return table;
  }
  for (const auto& object : all->objects()) {
    if (!object.has_pose_in_frame() || !parts_.isShown(object.path())) continue;
    const auto frame = scene_.framePose(object.frame());
    if (frame) add(object.path(), *frame * robotlink::pose3(object.pose_in_frame()));
  }
  return table;
}

void SceneView::keepObjects() {
  keep(
      "modes", [this] { return modes_->state(); },
      [this](const QJsonValue& value) { modes_->restore(value.toObject()); });
  // Older layouts have this one only.
  keep(
      "wireFrame", [this] { return modes_->surface() == Surface::kWire; },
      [this](const QJsonValue& value) {
        if (value.toBool()) modes_->setSurface(Surface::kWire);
      });
  keep(
      "looks", [this] { return parts_.looks().state(); },
      [this](const QJsonValue& value) { parts_.changeLooks().restore(value.toArray()); }, Names::kObjects);
  keep(
      "only", [this] { return QString::fromStdString(parts_.only()); },
      [this](const QJsonValue& value) { limitTo(value.toString().toStdString()); }, Names::kObjects);
  keep(
      "followed", [this] { return QString::fromStdString(followed_); },
      [this](const QJsonValue& value) {
        followed_ = value.toString().toStdString();
        extent_.reset();
      },
      Names::kObjects);
  keep("firstPerson", firstPerson_);
}

}  // namespace widgets
