// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneView.h"

#include <QAction>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <iterator>

#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/MapConversions.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/Requests.h"
#include "widgets/RobotChoice.h"
#include "widgets/drawings/DrawingsModel.h"
#include "widgets/field/FieldPainter.h"
#include "widgets/picture/PoseMenu.h"
#include "widgets/scene/SceneCanvas.h"
#include "widgets/scene/SceneHands.h"
#include "widgets/scene/SceneModes.h"
#include "widgets/world/ObjectPose.h"
#include "widgets/world/SceneSelection.h"
#include "widgets/world/ShownMap.h"
#include "widgets/world/WorldDrawings.h"

namespace widgets {
namespace {

const ViewRegistration kSceneViewRegistration{
    {"scene", QT_TRANSLATE_NOOP("View", "Scene"),
     QT_TRANSLATE_NOOP("View", "The world in three dimensions, with the robots' drawings"), "scene", true,
     create<SceneView>}};

}  // namespace

SceneView::SceneView(ViewContext& context, QWidget* parent)
    : PictureView(context, "scene", "scene.png", parent) {
  createActions();
  createCameraActions();
  createViews();
  connectSignals();
  connectCamera();
  connectDrag();
  connectEvents();
  keepChoices();
  canvas_->setOverview(box());
  tick();
}

SceneView::~SceneView() = default;

void SceneView::createActions() {
  modes_ = new SceneModes(this);
  grid_ = makeToggle(
      this, "grid", {"sceneGrid", tr("Grid"), tr("Shows lines every half meter around the field"), Qt::Key_G},
      true);
  labels_ = makeToggle(
      this, "labels",
      {"sceneLabels", tr("Names"), tr("Shows the names of robots and the texts of drawings"), Qt::Key_L},
      true);
  sensors_ = makeToggle(
      this, "camera",
      {"sceneSensors", tr("Cameras and ranges"),
       tr("Shows the fields of view of cameras and range sensors, for robots without a scene"), Qt::Key_C},
      true);
  move_ = makeToggle(this, "grab",
                     {"sceneMove", tr("Move robots and ball"),
                      tr("Dragging a robot or the ball places it; otherwise only with Control. The wheel "
                         "turns what is dragged"),
                      Qt::Key_M},
                     true);
  send_ =
      makeToggle(this, "send",
                 {"sceneSend", tr("Keys and clicks for controllers"),
                  tr("Keys and the left button are sent to the controllers of the simulated scene, such as "
                     "that of a lift; the right and the middle button still move the camera"),
                  Qt::Key_K});
}

void SceneView::createCameraActions() {
  reset_ = makeAction(
      this, "fit",
      {"sceneReset", tr("Reset camera"), tr("Shows the whole field or building from the side"), Qt::Key_R});
  fromAbove_ =
      makeAction(this, "top-view",
                 {"sceneFromAbove", tr("From above"), tr("From above: looks down on the scene"), Qt::Key_A});
  behind_ = makeToggle(this, "behind",
                       {"sceneBehind", tr("Over the shoulder"),
                        tr("Looks over the robot's shoulder and follows it"), Qt::Key_B});
  follow_ = makeToggle(
      this, "follow",
      {"sceneFollow", tr("Follow the robot"), tr("Moves the camera with the robot"), Qt::Key_F}, true);
  firstPerson_ =
      makeToggle(this, "eye",
                 {"sceneFirstPerson", tr("First person"),
                  tr("Looks from the camera of the followed object, or from the object itself"), Qt::Key_E});
  ride_.setMode(CameraRide::Mode::kBeside);
}

void SceneView::createViews() {
  canvas_ = new SceneCanvas(SceneRenderer::create, this);
  canvas_->setContextMenuPolicy(Qt::PreventContextMenu);
  hands_ = new SceneHands(context(), *canvas_, scene_, *this);
  const Side side = makeDrawings({QStringLiteral("field"), QStringLiteral("robot")});
  assemble({createToolRow(side.toggle)}, canvas_, side, {});
}

QWidget* SceneView::createToolRow(QAction* showDrawings) {
  QHBoxLayout* row = makeToolRow(this);
  robots_ = new RobotChoice("sceneRobot", row->parentWidget());
  robots_->setToolTip(tr("Whose drawings are shown, and which robot the camera follows"));
  row->addWidget(robots_);
  row->addSpacing(6);
  addButtons(row, {reset_, fromAbove_, behind_, follow_, firstPerson_});
  row->addSpacing(6);
  addButtons(row, {hands_->palette(), hands_->undo(), hands_->redo(), hands_->handles(), hands_->ownAxes()});
  state_ = addWideLabel(row, "sceneState", tr("Whether drawings of earlier frames are shown"));
  state_->setMinimumWidth(state_->fontMetrics().horizontalAdvance(tr("faded")));
  addPoses(row);
  addButtons(row, {move_, send_, modes_->wireFrame()});
  row->addWidget(makeMenuButton(row->parentWidget(),
                                {"sceneSurfacesButton", tr("Surfaces"), tr("How surfaces are drawn")},
                                modes_->surfaces()));
  row->addWidget(makeMenuButton(
      row->parentWidget(),
      {"sceneLayersButton", tr("Layers"), tr("What is shown: shapes, solids, forces, joints, sensors, ...")},
      modes_->layers()));
  addButtons(row, {grid_, labels_, sensors_, zoomOut(), zoomIn(), showDrawings});
  return row->parentWidget();
}

void SceneView::connectSignals() {
  connect(modes_, &SceneModes::changed, this, &SceneView::tick);
  connect(grid_, &QAction::toggled, canvas_, &SceneCanvas::setGrid);
  connect(labels_, &QAction::toggled, canvas_, &SceneCanvas::setLabels);
  connect(move_, &QAction::toggled, this, &SceneView::tick);
  connect(sensors_, &QAction::toggled, this, &SceneView::tick);
  drawings()->listStreams(&StreamFigures::canShow);
  connect(drawings(), &DrawingsModel::shownChanged, this, &SceneView::tick);
  connect(robots_, &RobotChoice::choiceChanged, this, [this] {
    followed_.clear();
    extent_.reset();
    ride_.forget();
    tick();
  });
  connect(canvas_, &SceneCanvas::modelClicked, this, [this](const QString& model) {
    sceneSelection(this->context()).select(model.toStdString());
    const auto& robots = session().robots();
    if (std::ranges::find(robots, model.toStdString()) != robots.end())
      session().selectRobot(model.toStdString());
  });
  connect(canvas_, &SceneCanvas::nothingWanted, this, [this] { sceneSelection(this->context()).select({}); });
  connect(canvas_, &QWidget::customContextMenuRequested, this, &SceneView::showContextMenu);
}

void SceneView::connectCamera() {
  connect(reset_, &QAction::triggered, this, [this] {
    letGo();
    canvas_->setOverview(box());
  });
  connect(fromAbove_, &QAction::triggered, this, [this] {
    letGo();
    canvas_->setCamera(SceneCamera::fromAbove(canvas_->size(), box()));
  });
  // At most one of the three is checked.
  for (QAction* chosen : {behind_, follow_, firstPerson_}) {
    connect(chosen, &QAction::toggled, this, [this, chosen](bool on) {
      for (QAction* other : {behind_, follow_, firstPerson_})
        if (on && other != chosen) other->setChecked(false);
      ride();
    });
  }
}

void SceneView::connectDrag() {
  connect(canvas_, &SceneCanvas::dragStarted, this, [this](const QString& model, double x, double y) {
    const auto pose = scene_.modelPose(model.toStdString());
    if (!pose) return;
    drag_.begin(model.toStdString(), robotlink::groundPose(*pose), {x, y});
    hands_->beginDrag(model.toStdString());
  });
  connect(canvas_, &SceneCanvas::dragMoved, this, [this](double x, double y, bool isSnapping) {
    drag_.moveTo({x, y}, isSnapping ? GizmoDrag::kSnapLength : 0);
  });
  connect(canvas_, &SceneCanvas::dragTurned, this, [this](double angle) { drag_.turn(angle); });
  connect(canvas_, &SceneCanvas::dragEnded, this, [this](double vx, double vy) {
    drag_.end(session());
    hands_->endDrag(drag_.model(), drag_.wanted(), {vx, vy});
    tick();
  });
  connect(canvas_, &SceneCanvas::dragCanceled, this, [this] {
    drag_.cancel();
    hands_->cancelDrag(drag_.model());
    tick();
  });
  connect(hands_, &SceneHands::followWanted, this, [this](const QString& robot) {
    robots_->setChoice(robot);
    follow_->setChecked(true);
  });
}

void SceneView::connectEvents() {
  connect(send_, &QAction::toggled, this, [this](bool on) {
    canvas_->setSendsEvents(on);
    if (on) canvas_->setFocus();
  });
  connect(canvas_, &SceneCanvas::eventHappened, this, [this](const SceneEvent& happened) {
    robotcontrol::Request request;
    auto& event = *request.mutable_send_event();
    event.set_kind(static_cast<robotcontrol::ViewEvent::Kind>(happened.kind));
    event.set_view("scene");
    event.set_key(happened.key.toStdString());
    if (happened.kind >= SceneEvent::Kind::kMousePressed) {
      event.set_button(1);
      robotlink::assign(*event.mutable_origin(), happened.origin);
      robotlink::assign(*event.mutable_direction(), happened.direction);
    }
    // Failures are ignored: without a simulation, nobody misses the events.
    ask(session(), {}, std::move(request), this, [](bool, const QString&) {});
  });
}

bool SceneView::isPictureReady() const {
  return canvas_->upToDate() || canvas_->hasFailed();
}

void SceneView::tick() {
  const auto shown = session().timeline().shown();
  scene_.update(session().store(), shown);
  if (parts_.update(session().store())) {
    layers_.forget();
    extent_.reset();
    isMeasured_ = false;
  }
  followMap();
  drawings()->refresh(session(), session().selectedRobot());
  robots_->refresh(session());
  poses()->refresh(session());
  beliefs_ = robotBeliefs(session(), scene_, context().field.get(), shown);
  placeDrawings(beliefs_, session().store(), poses()->choice().toStdString(), shown);
  ownModels_.update(context(), scene_, beliefs_, shown);
  drag_.tick(session());
  const QString refusal = drag_.refusal();
  hands_->tick();
  canvas_->setNotice(refusal.isEmpty() ? hands_->notice() : tr("It cannot be placed here: %1").arg(refusal));
  const bool log = session().store().find(robotlink::streams::kReplay) != nullptr;
  canvas_->setHint(
      log ? tr("This log holds no scene; the field view shows the estimated poses of its robots.")
      : parts_.only().empty() || parts_.objects().all() == nullptr
          ? tr("No scene yet: start a simulation, or open a log.")
      : parts_.objects().find(parts_.only()) == nullptr
          ? tr("There is no '%1' in this scene.").arg(QString::fromStdString(parts_.only()))
          : tr("%1 has no shape to be shown.").arg(QString::fromStdString(parts_.only())));
  canvas_->setMovable(scene_.models(), move_->isChecked());
  follow();
  VisibleScene visible = contents(beliefs_);
  measure(visible.bodies);
  canvas_->setContents(std::move(visible));
}

void SceneView::measure(const std::vector<SceneBody>& bodies) {
  if (isMeasured_ || mapBox_ || context().field || !parts_.only().empty()) return;
  sceneBox_ = ShownParts::boxAround(bodies);
  isMeasured_ = sceneBox_.has_value();
  if (isMeasured_ && canvas_->overview()) canvas_->setOverview(box());
}

VisibleScene SceneView::contents(const std::vector<RobotBelief>& beliefs) {
  VisibleScene contents;
  contents.bodies = assembly_.bodies(scene_);
  std::ranges::copy(ownModels_.bodies(contents.bodies.empty() ? std::optional(box()) : std::nullopt),
                    std::back_inserter(contents.bodies));
  parts_.apply(contents.bodies, modes_->surface());
  const auto drawings = worldDrawings(session(), scene_, streamFigures_, beliefs, robots_->robots(session()),
                                      this->drawings()->shown(), session().timeline().shown());
  // Drawings of robots belong to the surroundings.
  if (parts_.only().empty()) contents.drawings = assembly_.drawings(drawings);
  if (sensors_->isChecked()) std::ranges::copy(ownModels_.sensors(), std::back_inserter(contents.drawings));
  showState(std::ranges::any_of(drawings, &WorldDrawing::old));
  contents.ghosts = ghosts(contents.bodies);
  std::ranges::copy(hands_->ghosts(contents.bodies), std::back_inserter(contents.ghosts));
  contents.light = sceneLight(session().store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, session().timeline().shown()));
  contents.refused = !drag_.refusal().isEmpty();
  contents.labels = SceneAssembly::labels(contents.drawings);
  addNames(beliefs, contents.labels);
  showSelection(contents.bodies, contents.labels);
  std::ranges::copy(ownModels_.names(), std::back_inserter(contents.labels));
  const QPalette colors = palette();
  layers_.add({session(), scene_, parts_, *modes_, assembly_, colors, sceneSelection(context()).object()},
              contents);
  return contents;
}

/// A word where there is no room for all of it.
void SceneView::showState(bool faded) {
  const QString text = faded ? tr("faded: drawn in earlier frames") : QString();
  const bool fits = state_->fontMetrics().horizontalAdvance(text) < state_->width();
  state_->setText(fits ? text : tr("faded"));
}

/// The dragged model's bodies, at the place where it is dragged.
std::vector<SceneBody> SceneView::ghosts(const std::vector<SceneBody>& bodies) const {
  std::vector<SceneBody> ghosts;
  const auto pose = drag_.active() ? scene_.modelPose(drag_.model()) : std::nullopt;
  if (!pose) return ghosts;
  const robotlink::Pose3 move =
      poseOnGround(drag_.wanted()) * poseOnGround(robotlink::groundPose(*pose)).inverse();
  for (const SceneBody& body : bodies) {
    if (body.model == drag_.model()) ghosts.push_back({body.shape, move * body.inField, {}});
  }
  return ghosts;
}

std::string SceneView::highlighted(const std::vector<SceneBody>& bodies) const {
  for (const std::string& each : parts_.objects().lineage(sceneSelection(context()).object())) {
    if (std::ranges::any_of(bodies, [&](const SceneBody& body) { return isPartOf(body, each); })) return each;
  }
  return {};
}

void SceneView::showSelection(const std::vector<SceneBody>& bodies, std::vector<SceneLabel>& labels) {
  const auto* found = worldObject(session(), sceneSelection(context()).object());
  canvas_->setSelected(found == nullptr ? std::string() : highlighted(bodies));
  if (found == nullptr || std::ranges::find(session().robots(), found->path()) != session().robots().end())
    return;
  if (const auto pose = worldPose(*found, scene_))
    labels.push_back({pose->translation(), QString::fromStdString(found->name()), Qt::white, 11, true});
}

void SceneView::addNames(const std::vector<RobotBelief>& beliefs, std::vector<SceneLabel>& labels) const {
  constexpr double kAboveRobot = 0.34;  // m
  for (const RobotBelief& belief : beliefs) {
    if (!belief.truth || !parts_.isShown(belief.robot)) continue;
    labels.push_back({{belief.truth->x, belief.truth->y, kAboveRobot},
                      QString::fromStdString(belief.robot),
                      Qt::white,
                      11,
                      true});
  }
}

std::optional<robotlink::Pose2> SceneView::robotPose() const {
  const auto found = std::ranges::find(beliefs_, robots_->robot(session()), &RobotBelief::robot);
  return found == beliefs_.end() ? std::nullopt : found->drawingPose();
}

void SceneView::ride() {
  using Mode = CameraRide::Mode;
  if (!firstPerson_->isChecked()) endLookingOut();
  ride_.setMode(behind_->isChecked() ? Mode::kBehind : follow_->isChecked() ? Mode::kBeside : Mode::kOff);
  tick();
}

void SceneView::letGo() {
  behind_->setChecked(false);
  follow_->setChecked(false);
  firstPerson_->setChecked(false);
}

void SceneView::follow() {
  // Following would move the dragged model away from the mouse.
  if (drag_.active() || canvas_->isDragging()) return;
  if (firstPerson_->isChecked()) return lookOut();
  const auto followed = subject();
  if (!followed) return ride_.forget();
  canvas_->setCamera(ride_.step(canvas_->camera(), *followed, canvas_->overview()));
}

SceneBox SceneView::box() const {
  if (mapBox_) return *mapBox_;
  const auto& field = context().field;
  if (!field) return sceneBox_.value_or(SceneBox());
  const QSizeF ground = fieldExtent(*field);
  return {.size = {ground.width(), ground.height(), field->beaconBaseHeight + 2 * field->beaconBandHeight}};
}

void SceneView::followMap() {
  const auto map = shownMap(session());
  if (map == map_) return;
  map_ = map;
  mapBox_.reset();
  if (map) {
    const auto bounds = robotlink::groundMap(*map).bounds();
    const robotlink::Vector2 size = bounds.high - bounds.low;
    mapBox_ = SceneBox{(bounds.low + bounds.high) / 2, {size.x(), size.y(), 1}};
  }
  if (canvas_->overview()) canvas_->setOverview(box());
}

void SceneView::showContextMenu(const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("sceneMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  hands_->fillMenu(*menu, at);
  if (const auto hit = canvas_->hitAt(at))
    addObjectMenus(*menu, hit->object.empty() ? hit->model : hit->object);
  if (const int hidden = parts_.looks().hiddenCount(); hidden > 0) {
    QAction* show = menu->addAction(
        icon("eye"),
        hidden == 1 ? tr("Show the hidden part again") : tr("Show %1 hidden parts again").arg(hidden), this,
        [this] { showObject({}); });
    show->setObjectName(QStringLiteral("sceneShowHidden"));
  }
  if (!parts_.only().empty()) {
    QAction* all =
        menu->addAction(icon("scene"), tr("Show the whole scene"), this, [this] { showOnly({}, false); });
    all->setObjectName(QStringLiteral("sceneShowWhole"));
  }
  if (!menu->isEmpty()) menu->addSeparator();
  menu->addActions({reset_, fromAbove_, behind_, follow_, firstPerson_});
  menu->addMenu(modes_->surfaces())->setText(tr("Surfaces"));
  menu->addMenu(modes_->layers())->setText(tr("Layers"));
  menu->addSeparator();
  menu->addActions({copyAction(), copyNumbersAction(), saveAction()});
  menu->popup(canvas_->mapToGlobal(at));
}

void SceneView::keepChoices() {
  keep("grid", grid_);
  keep("labels", labels_);
  keep("move", move_);
  keep("handles", hands_->handles());
  keep("ownAxes", hands_->ownAxes());
  keep("sensors", sensors_);
  keep("send", send_);
  keep("robot", robots_);
  keep(
      "camera", [this] { return stateOf(before_.value_or(canvas_->camera())); },
      [this](const QJsonValue& value) { canvas_->setCamera(cameraOf(value.toObject())); });
  keep(
      "overview", [this] { return canvas_->overview(); },
      [this](const QJsonValue& value) {
        if (value.toBool(true)) canvas_->setOverview(box());
      });
  // The camera keeps its pose relative to the robot.
  keep("behind", behind_);
  keep(
      "follow", [this] { return follow_->isChecked(); },
      [this](const QJsonValue& value) {
        follow_->setChecked(value.toBool(!behind_->isChecked()));
        ride_.forget();
      });
  keepObjects();
}

}  // namespace widgets
