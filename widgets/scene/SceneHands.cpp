// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneHands.h"

#include <QAction>
#include <QInputDialog>
#include <QMenu>
#include <QPointer>

#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Requests.h"
#include "widgets/scene/SceneCanvas.h"
#include "widgets/scene/ScenePalette.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/world/ObjectPose.h"
#include "widgets/world/SceneSelection.h"
#include "widgets/world/SceneState.h"
#include "widgets/world/WorldDrawings.h"

namespace widgets {
namespace {

using robotlink::Pose3;

constexpr int kHandNoticeTicks = 150;
/// The distance of a copy from its original, m.
constexpr double kCopyShift = 0.5;

/// Slower than this (m/s) what is let go of is placed, not thrown.
constexpr double kMinThrow = 0.5, kMaxThrow = 20;

QString words(const robotlink::Error& error) {
  return QString::fromStdString(error.describe());
}

}  // namespace

SceneHands::SceneHands(ViewContext& context, SceneCanvas& canvas, const SceneState& scene, QWidget& view)
    : QObject(&view), context_(context), canvas_(canvas), scene_(scene) {
  setObjectName(QStringLiteral("sceneHands"));
  palette_ = new ScenePalette(&view);
  createActions(view);
  createMoreActions(view);
  connectSignals();
  showHistory();
}

SceneHands::~SceneHands() = default;

SceneEdits& SceneHands::edits() const {
  return sceneEdits(context_);
}

const robotcontrol::SimulationStatus* SceneHands::status() const {
  return context_.session.store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, context_.session.timeline().newest());
}

void SceneHands::createActions(QWidget& view) {
  handles_ =
      makeToggle(&view, "goal",
                 {"sceneHandles", tr("Handles"),
                  tr("Shows handles at the selected object that move and turn it; Control: in steps of "
                     "0.1 m and 15°, Esc: back"),
                  Qt::Key_H},
                 true);
  ownAxes_ = makeToggle(&view, "rotate",
                        {"sceneOwnAxes", tr("Own axes"),
                         tr("Aligns the handles with the object instead of the field"), Qt::Key_X});
  undo_ = makeAction(&view, "undo", {"sceneEditUndo", tr("Undo"), {}, QKeySequence::Undo});
  redo_ = makeAction(&view, "redo", {"sceneEditRedo", tr("Redo"), {}, QKeySequence::Redo});
  showPalette_ =
      makeAction(&view, "add",
                 {"sceneShowPalette", tr("Add objects…"),
                  tr("Lists objects and models that can be dragged into the scene"), Qt::Key_Insert});
}

void SceneHands::createMoreActions(QWidget& view) {
  duplicate_ = makeAction(&view, "copy",
                          {"sceneDuplicate", tr("Duplicate"),
                           tr("Adds another one beside it to the scene's text"), tr("Ctrl+D")});
  erase_ = makeAction(
      &view, "remove",
      {"sceneErase", tr("Delete"), tr("Removes the object from the scene's text"), QKeySequence::Delete});
  rename_ =
      makeAction(&view, "edit",
                 {"sceneRename", tr("Rename…"), tr("Renames the object in the scene's text"), Qt::Key_F2});
  write_ = makeAction(&view, "send",
                      {"sceneWrite", tr("Write to the scene"),
                       tr("Makes the object's present pose its initial one in the scene's text; save the "
                          "file to keep it"),
                       tr("Ctrl+Shift+W")});
  pin_ = makeAction(
      &view, "lock",
      {"scenePin", tr("Pin or release"),
       tr("Holds the object where it is, so that nothing can move it, or releases it"), Qt::Key_P});
  goToText_ = makeAction(
      &view, "labels",
      {"sceneGoToText", tr("Go to its text"), tr("Shows the object in the scene editor"), tr("Ctrl+G")});
  properties_ = makeAction(
      &view, "settings",
      {"sceneShowProperties", tr("Properties"), tr("Shows the properties of the object"), tr("Alt+Return")});
}

void SceneHands::connectSignals() {
  connect(&canvas_, &SceneCanvas::gizmoMoved, this, &SceneHands::moveGizmo);
  connect(&canvas_, &SceneCanvas::gizmoEnded, this, &SceneHands::endGizmo);
  connect(&canvas_, &SceneCanvas::gizmoCanceled, this, &SceneHands::cancelGizmo);
  connect(&canvas_, &SceneCanvas::dropped, this, &SceneHands::insert);
  connect(palette_, &ScenePalette::chosen, this, &SceneHands::insertInView);
  connect(undo_, &QAction::triggered, this, [this] { walk(true); });
  connect(redo_, &QAction::triggered, this, [this] { walk(false); });
  connect(duplicate_, &QAction::triggered, this, &SceneHands::duplicate);
  connect(erase_, &QAction::triggered, this, &SceneHands::erase);
  connect(rename_, &QAction::triggered, this, &SceneHands::rename);
  connect(write_, &QAction::triggered, this, &SceneHands::write);
  connect(pin_, &QAction::triggered, this, &SceneHands::pin);
  connect(goToText_, &QAction::triggered, this,
          [this] { run("scene.edit", sceneSelection(context_).object()); });
  connect(properties_, &QAction::triggered, this, [this] { run("view.show", "scene-properties"); });
  connect(showPalette_, &QAction::triggered, this, [this] {
    palette_->fill(sceneBench(context_));
    // The palette opens at the edge of its canvas; window managers would put it anywhere.
    if (!palette_->isVisible()) palette_->move(canvas_.mapToGlobal(QPoint(8, 8)));
    palette_->show();
    palette_->raise();
  });
  connect(&edits(), &SceneEdits::historyChanged, this, &SceneHands::showHistory);
}

std::optional<SceneHands::Target> SceneHands::target() const {
  const auto* selected = worldObject(context_.session, sceneSelection(context_).object());
  if (selected == nullptr) return std::nullopt;
  const bool isPart = !selected->model().empty() && selected->path() != selected->model();
  const auto* whole = isPart ? worldObject(context_.session, selected->model()) : selected;
  const auto pose = whole == nullptr ? std::nullopt : worldPose(*whole, scene_);
  if (!pose) return std::nullopt;
  return Target{whole->path(), *pose, whole->is_movable()};
}

QString SceneHands::notice() const {
  constexpr int kPatience = 10;  // ticks
  return notice_.isEmpty() && busyTicks_ > kPatience ? tr("The changed scene is being checked…") : notice_;
}

void SceneHands::settle() {
  constexpr int kMaxTicks = 90;
  if (!settling_ || edits().isBusy()) return;
  const auto now = target();
  const bool isThere = !now || now->object != settling_->object || !now->pose.isApprox(settling_->pose, 1e-6);
  if (isThere || ++settlingTicks_ > kMaxTicks) settling_.reset();
}

void SceneHands::tick() {
  settle();
  busyTicks_ = edits().isBusy() ? busyTicks_ + 1 : 0;
  if (unsent_ && dragged_ && dragged_->isLive) ask(placeRequest(dragged_->object, wanted_));
  unsent_ = false;
  if (noticeTicks_ > 0 && --noticeTicks_ == 0) notice_.clear();
  const auto at = handles_->isChecked() ? target() : std::nullopt;
  const bool canMove = at && (at->isLive || edits().canChange());
  if (!canMove) return canvas_.setGizmo(std::nullopt);
  Gizmo gizmo{dragged_ || settling_ ? wanted_ : at->pose, Eigen::Matrix3d::Identity()};
  if (ownAxes_->isChecked()) gizmo.axes = gizmo.pose.linear();
  canvas_.setGizmo(gizmo);
}

std::vector<SceneBody> SceneHands::ghosts(const std::vector<SceneBody>& bodies) const {
  std::vector<SceneBody> ghosts;
  const auto& moved = dragged_ ? dragged_ : settling_;
  const auto now = moved ? target() : std::nullopt;
  if (!now || now->object != moved->object) return ghosts;
  const Pose3 move = wanted_ * now->pose.inverse();
  for (const SceneBody& body : bodies) {
    if (isPartOf(body, moved->object)) ghosts.push_back({body.shape, move * body.inField, {}});
  }
  return ghosts;
}

// ---- Moving

void SceneHands::moveGizmo(const Pose3& pose) {
  settling_.reset();
  if (!dragged_) dragged_ = target();
  wanted_ = pose;
  unsent_ = true;
}

void SceneHands::endGizmo(const Pose3& pose) {
  if (!dragged_) return;
  const Target moved = *dragged_;
  dragged_.reset();
  unsent_ = false;
  if (moved.isLive) {
    ask(placeRequest(moved.object, pose));
    return addMove(moved.object, moved.pose, pose);
  }
  // The object is shown at the new place until the simulation has moved it.
  settling_ = moved;
  settlingTicks_ = 0;
  edits().setPose(moved.object, objectPose(pose), told([](const std::string&) {}));
}

void SceneHands::cancelGizmo() {
  if (dragged_ && dragged_->isLive) ask(placeRequest(dragged_->object, dragged_->pose));
  dragged_.reset();
  unsent_ = false;
}

void SceneHands::beginDrag(const std::string& model) {
  const auto* object = worldObject(context_.session, model);
  ground_ = object == nullptr ? std::nullopt : worldPose(*object, scene_);
}

void SceneHands::endDrag(const std::string& model, const robotlink::Pose2& wanted,
                         const robotlink::Vector2& velocity) {
  const auto before = std::exchange(ground_, std::nullopt);
  if (!before) return;
  const double speed = velocity.norm();
  const bool isThrown = speed >= kMinThrow && status() != nullptr && status()->running();
  if (isThrown) {
    const robotlink::Vector2 limited = velocity * std::min(1.0, kMaxThrow / speed);
    robotcontrol::Request request;
    auto& thrown = *request.mutable_throw_model();
    thrown.set_model(model);
    thrown.mutable_velocity()->set_x(limited.x());
    thrown.mutable_velocity()->set_y(limited.y());
    ask(std::move(request));
  }
  // The object keeps its height, roll and pitch.
  const Pose3 after = poseOnGround(wanted) * poseOnGround(robotlink::groundPose(*before)).inverse() * *before;
  if (!after.isApprox(*before, 1e-6)) addMove(model, *before, after);
}

void SceneHands::cancelDrag(const std::string& model) {
  const auto before = std::exchange(ground_, std::nullopt);
  if (before) ask(placeRequest(model, *before));
}

void SceneHands::pin() {
  const auto at = target();
  if (!at) return;
  if (!at->isLive) return report(tr("Only what moves can be pinned"));
  const auto* now = status();
  const bool isPinned = now != nullptr && std::ranges::any_of(now->pinned(), [&](const std::string& path) {
                          return path == at->object || path.starts_with(at->object + "/");
                        });
  const auto request = [&](bool pinned) {
    robotcontrol::Request wanted;
    wanted.mutable_pin_object()->set_path(at->object);
    wanted.mutable_pin_object()->set_pinned(pinned);
    return wanted;
  };
  ask(request(!isPinned));
  const QString name = QString::fromStdString(at->object);
  edits().addRequests(isPinned ? tr("Release %1").arg(name) : tr("Pin %1").arg(name), request(isPinned),
                      request(!isPinned));
}

void SceneHands::addMove(const std::string& model, const Pose3& before, const Pose3& after) {
  edits().addRequests(tr("Move %1").arg(QString::fromStdString(model)), placeRequest(model, before),
                      placeRequest(model, after));
}

// ---- The scene's text

void SceneHands::insert(const QString& kind, double x, double y) {
  edits().insert(kind.toStdString(), x, y, told(selecting()));
}

void SceneHands::insertInView(const QString& kind) {
  const auto place = canvas_.placeAt(QPointF(canvas_.width() / 2.0, canvas_.height() / 2.0));
  if (place) insert(kind, place->x(), place->y());
}

void SceneHands::duplicate() {
  const auto at = target();
  if (!at) return;
  Pose3 pose = at->pose;
  pose.translation() += robotlink::Vector3(kCopyShift, kCopyShift, 0);
  edits().copy(at->object, objectPose(pose), told(selecting()));
}

void SceneHands::erase() {
  const auto at = target();
  if (!at) return;
  edits().erase(at->object, told([this](const std::string&) { sceneSelection(context_).select({}); }));
}

void SceneHands::rename() {
  const auto at = target();
  if (!at) return;
  const std::string before = at->object.substr(at->object.find(':') + 1);
  bool accepted = false;
  const QString name =
      QInputDialog::getText(&canvas_, tr("Rename"), tr("New name of %1:").arg(QString::fromStdString(before)),
                            QLineEdit::Normal, QString::fromStdString(before), &accepted);
  if (!accepted) return;
  edits().rename(at->object, name.toStdString(), told(selecting()));
}

void SceneHands::write() {
  const auto at = target();
  if (!at) return;
  edits().setPose(
      at->object, objectPose(at->pose), told([this](const std::string& object) {
        report(tr("%1 now starts here; save the scene to keep that").arg(QString::fromStdString(object)));
      }));
}

SceneEdits::Told SceneHands::told(std::function<void(const std::string& object)> done) {
  // The view may be closed meanwhile.
  return [hands = QPointer<SceneHands>(this),
          done = std::move(done)](const robotlink::Result<std::string>& object) {
    if (!hands) return;
    const bool isDropped = !object && object.error().id == SceneEdits::kDropped;
    hands->report(object || isDropped ? QString() : words(object.error()));
    if (!object) hands->settling_.reset();
    if (object) done(*object);
  };
}

std::function<void(const std::string&)> SceneHands::selecting() {
  return [this](const std::string& object) { sceneSelection(context_).select(object); };
}

// ---- Menu and history

void SceneHands::fillMenu(QMenu& menu, const QPoint& at) {
  const auto hit = canvas_.hitAt(at);
  const std::string owner = hit ? hit->owner() : std::string();
  // A room that is not selected has no entries of its own: the menu is for a place of the ground.
  const std::string& selected = sceneSelection(context_).object();
  const bool isSelected = selected == owner || selected.starts_with(owner + "/");
  const bool isBehind = !owner.empty() && !isSelected && canvas_.isBackground(*hit);
  if (!owner.empty() && !isBehind) sceneSelection(context_).select(owner);
  const auto on = isBehind ? std::nullopt : target();
  if (on) {
    const bool isOwn = edits().isOwn(on->object);
    menu.addSection(QString::fromStdString(on->object));
    for (QAction* action : {duplicate_, erase_, rename_, write_}) action->setEnabled(isOwn);
    pin_->setEnabled(on->isLive);
    menu.addActions({duplicate_, erase_, rename_, write_, pin_});
    const auto& robots = context_.session.robots();
    if (std::ranges::find(robots, on->object) != robots.end()) {
      const QString robot = QString::fromStdString(on->object);
      auto* follow =
          menu.addAction(tr("Follow %1").arg(robot), this, [this, robot] { Q_EMIT followWanted(robot); });
      follow->setObjectName(QStringLiteral("sceneFollowThis"));
    }
    menu.addActions({goToText_, properties_});
    menu.addSeparator();
  }
  const auto place = canvas_.placeAt(at);
  if (place && edits().canChange()) {
    QMenu* add = menu.addMenu(tr("Add here"));
    add->setObjectName(QStringLiteral("sceneAddMenu"));
    for (const ScenePalette::Entry& entry : ScenePalette::entries(sceneBench(context_))) {
      QAction* action = add->addAction(entry.title, this, [this, kind = entry.kind, where = *place] {
        insert(kind, where.x(), where.y());
      });
      action->setObjectName(QStringLiteral("sceneAdd.") + entry.kind);
    }
  }
  menu.addActions({showPalette_, undo_, redo_});
  menu.addSeparator();
  // The keys are for what is selected then.
  connect(
      &menu, &QMenu::aboutToHide, this,
      [this] {
        for (QAction* action : {duplicate_, erase_, rename_, write_, pin_}) action->setEnabled(true);
      },
      Qt::QueuedConnection);
}

void SceneHands::walk(bool isUndo) {
  const auto done = isUndo ? edits().undo() : edits().redo();
  report(done ? QString() : words(done.error()));
}

void SceneHands::showHistory() {
  const SceneEdits& history = edits();
  undo_->setEnabled(history.canUndo());
  redo_->setEnabled(history.canRedo());
  undo_->setToolTip(history.canUndo() ? tr("Undoes: %1").arg(history.undoTitle())
                                      : tr("There is no change of the scene to undo"));
  redo_->setToolTip(history.canRedo() ? tr("Does again: %1").arg(history.redoTitle())
                                      : tr("There is no change of the scene to redo"));
}

void SceneHands::ask(robotcontrol::Request request) {
  widgets::ask(context_.session, {}, std::move(request), this, [this](bool accepted, const QString& reason) {
    report(accepted ? QString() : tr("This cannot be done: %1").arg(reason));
  });
}

void SceneHands::run(const char* command, const std::string& word) {
  const auto done = context_.commands.run(command, {word});
  report(done ? QString() : words(done.error()));
}

void SceneHands::report(const QString& text) {
  notice_ = text;
  noticeTicks_ = text.isEmpty() ? 0 : kHandNoticeTicks;
}

}  // namespace widgets
