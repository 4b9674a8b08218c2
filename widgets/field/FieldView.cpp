// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/FieldView.h"

#include <QAction>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/BaseSilence.h"
#include "widgets/Controls.h"
#include "widgets/RobotChoice.h"
#include "widgets/ShownText.h"
#include "widgets/drawings/DrawingsModel.h"
#include "widgets/field/FieldCanvas.h"
#include "widgets/field/GoalTool.h"
#include "widgets/field/PlaceNotice.h"
#include "widgets/field/TrailMenu.h"
#include "widgets/picture/MeasureTool.h"
#include "widgets/picture/PoseMenu.h"
#include "widgets/world/DriveAims.h"
#include "widgets/world/ShownMap.h"
#include "widgets/world/WorldDrawings.h"

namespace widgets {
namespace {

const ViewRegistration kFieldViewRegistration{
    {"field", QT_TRANSLATE_NOOP("View", "Field and map"),
     QT_TRANSLATE_NOOP("View",
                       "The field or the building from above: true and estimated poses, goals, and drawings"),
     "field", true, create<FieldView>}};

}  // namespace

FieldView::FieldView(ViewContext& context, QWidget* parent)
    : PictureView(context, "field", "field.png", parent) {
  createActions();
  canvas_ = new FieldCanvas(context.field, this);
  goals_ = new GoalTool(*this, *canvas_, session());
  createMeasure();
  createViews();
  connectSignals();
  connectDrag();
  keep("move", move_);
  keep("trails", showTrails_);
  keep(
      "trailsOf", [this] { return trailMenu_->save(); },
      [this](const QJsonValue& value) { trailMenu_->restore(value); });
  keep("errors", showErrors_);
  keep("send", goals_->send());
  keep("robot", robots_);
  tick();
  title_.clear();  // no one is connected to titleChanged() yet, so it must be emitted again
}

FieldView::~FieldView() = default;

void FieldView::createActions() {
  fit_ = makeFit(tr("Fits the whole field or map into the view"));
  turn_ =
      makeAction(this, "rotate", {"fieldTurn", tr("Turn"), tr("Turns the field by 90 degrees"), Qt::Key_R});
  move_ = makeToggle(this, "grab",
                     {"fieldMove", tr("Move robots and ball"),
                      tr("Dragging a robot or the ball places it; otherwise only with Shift. The wheel turns "
                         "what is dragged"),
                      Qt::Key_M},
                     true);
  showTrails_ = makeToggle(
      this, "trail",
      {"fieldTrails", tr("Trails"),
       tr("Shows the paths of the last seconds; the arrow chooses how long, and of what"), Qt::Key_T});
  trailMenu_ = new TrailMenu(this);
  showErrors_ =
      makeToggle(this, "errors",
                 {"fieldErrors", tr("Errors"),
                  tr("Shows lines from the true to the estimated positions of robot and ball"), Qt::Key_E});
}

void FieldView::createViews() {
  addToContextMenu(canvas_, {measure_->copy()});
  const Side side = makeDrawings({QStringLiteral("field"), QStringLiteral("robot")});
  assemble({createToolRow(side.toggle)}, canvas_, side, {measure_->bar(), createFooter()});
}

void FieldView::createMeasure() {
  const auto describe = [](const std::vector<QPointF>& points) {
    MeasureText text;
    QStringList parts;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const QPointF by = points[i + 1] - points[i];
      const QString direction =
          QStringLiteral("%1°").arg(directionDeg(points[i], points[i + 1], false), 0, 'f', 1);
      text.segments << tr("%1 mm, %2").arg(std::lround(1e3 * std::hypot(by.x(), by.y()))).arg(direction);
      parts << (i == 0 ? tr("AB %1") : tr("BC %1")).arg(text.segments.back());
    }
    if (points.size() > 2) {
      text.angle = QStringLiteral("%1°").arg(robotlink::degrees(angleAt(points)), 0, 'f', 1);
      parts << tr("angle at B %1").arg(text.angle);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const QString letter(QLatin1Char(static_cast<char>('A' + i)));
      parts << tr("%1 (%2, %3) mm")
                   .arg(letter)
                   .arg(std::lround(1e3 * points[i].x()))
                   .arg(std::lround(1e3 * points[i].y()));
    }
    text.line = parts.join(QStringLiteral("; "));
    return text;
  };
  const auto place = [this](const QPointF& at) -> std::optional<QPointF> {
    const robotlink::Vector2 ground = groundAt(canvas_->transform(), at);
    return QPointF(ground.x(), ground.y());
  };
  measure_ =
      new MeasureTool(*this, *canvas_, "field", {[this] { return canvas_->transform(); }, place, describe});
  canvas_->setMeasure(measure_);
}

QWidget* FieldView::createToolRow(QAction* showDrawings) {
  QHBoxLayout* row = makeToolRow(this);
  robots_ = new RobotChoice("fieldRobot", row->parentWidget());
  robots_->setToolTip(tr("Whose drawings and estimated poses are shown"));
  row->addWidget(robots_);
  row->addStretch(1);
  addPoses(row);
  addButtons(row, {goals_->send(), goals_->cancel(), move_});
  QToolButton* trails = makeButton(row->parentWidget(), showTrails_);
  trails->setMenu(trailMenu_);
  trails->setPopupMode(QToolButton::MenuButtonPopup);
  row->addWidget(trails);
  addButtons(row, {showErrors_, measure_->toggle(), turn_, fit_, zoomOut(), zoomIn(), showDrawings});
  return row->parentWidget();
}

QWidget* FieldView::createFooter() {
  QHBoxLayout* footer = makeFooter(this);
  time_ = addLabel(footer, "fieldTime", tr("Time that is shown"));
  state_ = addLabel(footer, "fieldState", tr("Which drawings are old"));
  footer->addStretch(1);
  cursor_ = addLabel(footer, "fieldCursor", tr("Place under the cursor, in the field's frame"));
  zoom_ = addLabel(footer, "fieldZoom", tr("Scale"));
  return footer->parentWidget();
}

void FieldView::connectSignals() {
  connect(fit_, &QAction::triggered, this, [this] {
    FieldViewport fitted;
    fitted.quarterTurns = canvas_->viewport().quarterTurns;
    canvas_->setViewport(fitted);
  });
  connect(turn_, &QAction::triggered, this, &FieldView::turn);
  connect(move_, &QAction::toggled, this, &FieldView::tick);
  connect(showTrails_, &QAction::toggled, this, &FieldView::tick);
  connect(showErrors_, &QAction::toggled, this, &FieldView::tick);
  connect(trailMenu_, &TrailMenu::changed, this, &FieldView::tick);
  drawings()->listStreams(&StreamFigures::canShow);
  connect(drawings(), &DrawingsModel::shownChanged, this, &FieldView::tick);
  connect(robots_, &RobotChoice::choiceChanged, this, &FieldView::tick);
  connect(canvas_, &FieldCanvas::robotClicked, this, [this](const QString& robot) {
    session().selectRobot(robot.toStdString());
    tick();
  });
  connect(canvas_, &FieldCanvas::viewportChanged, this, &FieldView::updateStatus);
  connect(canvas_, &FieldCanvas::cursorMoved, this, [this](double x, double y, bool inside) {
    cursor_->setText(inside ? tr("x %1 m  y %2 m").arg(x, 0, 'f', 3).arg(y, 0, 'f', 3) : QString());
  });
}

void FieldView::connectDrag() {
  connect(canvas_, &FieldCanvas::dragStarted, this, [this](const QString& model, double x, double y) {
    const auto pose = scene_.modelPose(model.toStdString());
    if (pose) drag_.begin(model.toStdString(), robotlink::groundPose(*pose), {x, y});
  });
  connect(canvas_, &FieldCanvas::dragMoved, this, [this](double x, double y) {
    drag_.moveTo({x, y});
    updateWanted();
  });
  connect(canvas_, &FieldCanvas::dragTurned, this, [this](double angle) {
    drag_.turn(angle);
    updateWanted();
  });
  connect(canvas_, &FieldCanvas::dragEnded, this, [this] {
    drag_.end(session());
    updateWanted();
  });
}

void FieldView::tick() {
  const auto shown = session().timeline().shown();
  scene_.update(session().store(), shown);
  robots_->refresh(session());
  drawings()->refresh(session(), robots_->robot(session()));
  poses()->refresh(session());
  updateGround();
  const std::vector<RobotBelief> shownRobots = beliefs();
  updateTrails();
  updateErrors();
  updateGoals(shownRobots);
  placeNotice_ = noticeOf(shownRobots);
  canvas_->setMovable(measure_->isOn() ? std::vector<std::string>() : scene_.models(), move_->isChecked());
  auto drawings = worldDrawings(session(), scene_, streamFigures_, shownRobots, robots_->robots(session()),
                                this->drawings()->shown(), shown);
  showAge(shownRobots, std::ranges::any_of(drawings, &WorldDrawing::old));
  canvas_->setContents(figures(shownRobots), std::move(drawings));
  drag_.tick(session());
  updateWanted();
  updateStatus();
}

std::optional<QString> FieldView::numbers() {
  TabTable table({QStringLiteral("figure"), QStringLiteral("of"), QStringLiteral("x m"),
                  QStringLiteral("y m"), QStringLiteral("heading deg"), QStringLiteral("deviation m"),
                  QStringLiteral("deviation deg")});
  const auto add = [&](const char* figure, const std::string& of, double x, double y,
                       const std::vector<double>& rest = {}) {
    QStringList cells{QLatin1String(figure), QString::fromStdString(of), QString::number(x, 'f', 4),
                      QString::number(y, 'f', 4)};
    for (const double number : rest)
      cells << (std::isnan(number) ? QString() : QString::number(number, 'f', 4));
    table.add(cells);
  };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const FieldFigures& figures = canvas_->figures();
  if (figures.ball) add("ball", kBallModel, figures.ball->x(), figures.ball->y());
  for (const RobotBelief& one : figures.robots) {
    if (one.truth)
      add("robot", one.robot, one.truth->x, one.truth->y, {robotlink::degrees(one.truth->heading)});
    if (one.estimate)
      add("estimate", one.robot, one.estimate->x, one.estimate->y,
          {robotlink::degrees(one.estimate->heading), one.positionDeviation,
           robotlink::degrees(one.headingDeviation)});
    if (one.ball) add("estimated ball", one.robot, one.ball->x(), one.ball->y(), {kNone, one.ballDeviation});
  }
  for (const DriveAim& aim : canvas_->goals().aims) {
    add("goal", aim.robot, aim.goal.x, aim.goal.y,
        {aim.anyHeading ? kNone : robotlink::degrees(aim.goal.heading)});
    for (const robotlink::Vector2& corner : aim.path) add("path", aim.robot, corner.x(), corner.y());
  }
  for (const auto& [of, places] : figures.trails)
    for (const robotlink::Vector2& place : places) add("trail", of, place.x(), place.y());
  return table.text();
}

void FieldView::updateGround() {
  canvas_->setField(context().field);
  const auto map = shownMap(session());
  canvas_->setMap(map);
  trails_.setReach(trailMenu_->reach(map != nullptr));
  const QString name = map ? QString::fromStdString(map->name()) : QString();
  QString title = !map ? tr("Field") : name.isEmpty() ? tr("Map") : tr("Map: %1").arg(name);
  // Several views of one field differ by whose beliefs they show.
  const QString robot = robots_->choice();
  if (robot == QLatin1String("*")) title = tr("%1, all robots").arg(title);
  if (!robot.isEmpty() && robot != QLatin1String("*")) title = tr("%1, %2").arg(title, robot);
  if (title == title_) return;
  title_ = title;
  Q_EMIT titleChanged(title);
}

bool FieldView::drives(const std::string& robot) const {
  const auto found = context().robots.find(robot);
  return found != context().robots.end() && found->second && found->second->drive;
}

std::vector<RobotBelief> FieldView::beliefs() const {
  const auto shown = session().timeline().shown();
  auto beliefs = robotBeliefs(session(), scene_, context().field.get(), shown);
  placeDrawings(beliefs, session().store(), poses()->choice().toStdString(), shown);
  for (RobotBelief& belief : beliefs) {
    if (!drives(belief.robot)) continue;
    const auto& drive = *context().robots.at(belief.robot)->drive;
    belief.body = {drive.length, drive.width};
    belief.silent = baseSilence(session().store(), belief.robot, shown).has_value();
  }
  return beliefs;
}

void FieldView::updateGoals(const std::vector<RobotBelief>& beliefs) {
  std::vector<DriveAim> aims;
  for (const RobotBelief& belief : beliefs) {
    if (belief.body.x() <= 0) continue;
    subscription_.want(session(), belief.robot,
                       {robotlink::kDriveState.name, robotlink::kRobotPose.name, robotlink::kDrivePath.name});
    auto aim = driveAim(session().store(), belief.robot, session().timeline().shown());
    if (!aim) continue;
    aim->color = belief.team;
    aims.push_back(std::move(*aim));
  }
  const std::string robot = robots_->robot(session());
  goals_->tick(drives(robot) ? robot : std::string(), std::move(aims));
}

FieldFigures FieldView::figures(const std::vector<RobotBelief>& beliefs) const {
  FieldFigures figures;
  figures.robots = beliefs;
  const std::vector<std::string> chosen = robots_->robots(session());
  for (RobotBelief& belief : figures.robots) {
    if (std::ranges::find(chosen, belief.robot) != chosen.end()) continue;
    belief.ball.reset();
    // Other real robots are still somewhere, so their estimates are shown as well.
    if (belief.truth) belief.estimate.reset();
  }
  figures.onMap = canvas_->map() != nullptr;
  figures.trails = trails_.places();
  figures.errorLines = showErrors_->isChecked();
  if (const auto ball = scene_.modelPose(kBallModel)) figures.ball = ball->translation().head<2>();
  if (const auto& field = context().field) {
    figures.ballRadius = field->ballRadius;
    const auto* color = field->color(field->ballColor);
    if (color != nullptr) figures.ballColor = QColor(color->r, color->g, color->b);
  }
  return figures;
}

Trails::Sources FieldView::trailSources() {
  Trails::Sources sources;
  const std::vector<std::string> chosen = robots_->robots(session());
  const auto path = [](const std::string& robot, const char* package) { return robot + '/' + package; };
  for (const std::string& robot : session().robots()) {
    const std::string frame = scene_.modelFrame(robot);
    if (trailMenu_->showsRobots() && !frame.empty()) sources.frames[frame] = robot;
    // Only its program knows the pose of a real robot.
    if (trailMenu_->showsRobots() && frame.empty())
      sources.estimates[robot] = path(robot, robotlink::kRobotPose.name);
    if (std::ranges::find(chosen, robot) == chosen.end()) continue;
    if (trailMenu_->showsEstimates() && !frame.empty()) {
      trailSubscription_.want(session(), robot, {robotlink::kRobotPose.name});
      sources.estimates[robot + kEstimateTrail] = path(robot, robotlink::kRobotPose.name);
    }
    if (trailMenu_->showsBall() && scene_.modelFrame(kBallModel).empty())
      sources.balls[robot + kBallTrail] = {path(robot, robotlink::kRobotPose.name),
                                           path(robot, robotlink::kBallModel.name)};
  }
  const std::string ball = scene_.modelFrame(kBallModel);
  if (trailMenu_->showsBall() && !ball.empty()) sources.frames[ball] = kBallModel;
  return sources;
}

void FieldView::updateTrails() {
  if (!showTrails_->isChecked()) return trails_.clear();
  trails_.update(session().store(), trailSources(), session().timeline().shown());
}

void FieldView::updateErrors() {
  if (!showErrors_->isChecked()) return;
  for (const std::string& robot : robots_->robots(session()))
    errorSubscription_.want(session(), robot, {robotlink::kRobotPose.name, robotlink::kBallModel.name});
}

void FieldView::updateWanted() {
  const QString refusal = drag_.refusal();
  const QString notGoing = goals_->refusal();
  canvas_->setNotice(!refusal.isEmpty()    ? tr("It cannot be placed here: %1").arg(refusal)
                     : !notGoing.isEmpty() ? tr("The robot cannot go there: %1").arg(notGoing)
                                           : placeNotice_);
  if (!drag_.active()) return canvas_->setWanted({});
  canvas_->setWanted(
      WantedPlace{drag_.model(), drag_.wanted(), drag_.model() == kBallModel, !refusal.isEmpty()});
}

QString FieldView::noticeOf(const std::vector<RobotBelief>& beliefs) const {
  const std::string robot = robots_->robot(session());
  if (!drives(robot)) return {};
  const auto belief = std::ranges::find(beliefs, robot, &RobotBelief::robot);
  // Requests do not help while the robot is silent.
  if (belief == beliefs.end() || belief->silent) return {};
  const auto* base = session().store().latestAs<robotcontrol::DriveState>(
      robot + '/' + robotlink::kDriveState.name, session().timeline().shown());
  return placeNotice(*belief, base, canvas_->map() != nullptr);
}

void FieldView::showAge(const std::vector<RobotBelief>& beliefs, bool faded) {
  QStringList old;
  const auto shown = session().timeline().shown();
  for (const RobotBelief& belief : beliefs) {
    if (belief.silent) old << silenceText(belief.robot, baseSilence(session().store(), belief.robot, shown));
  }
  if (faded) old << tr("faded: drawn in earlier frames");
  state_->setText(old.join(QStringLiteral(", ")));
  state_->setVisible(!old.isEmpty());
}

void FieldView::updateStatus() {
  const auto& timeline = session().timeline();
  const QString time = timeText(timeline.shown());
  time_->setText(timeline.live() ? time : tr("%1  history").arg(time));
  const QTransform transform = canvas_->transform();
  zoom_->setText(tr("%1 px/m").arg(qRound(std::hypot(transform.m11(), transform.m12()))));
}

void FieldView::turn() {
  FieldViewport viewport = canvas_->viewport();
  viewport.quarterTurns = (viewport.quarterTurns + 1) % 4;
  canvas_->setViewport(viewport);
}

QJsonObject FieldView::saveState() const {
  const FieldViewport& viewport = canvas_->viewport();
  QJsonObject state = PictureView::saveState();
  state[QStringLiteral("fit")] = viewport.fit;
  state[QStringLiteral("scale")] = viewport.scale;
  state[QStringLiteral("center")] = QJsonArray{viewport.center.x(), viewport.center.y()};
  state[QStringLiteral("quarterTurns")] = viewport.quarterTurns;
  return state;
}

void FieldView::restoreState(const QJsonObject& state) {
  PictureView::restoreState(state);
  const QJsonArray center = state[QStringLiteral("center")].toArray();
  FieldViewport viewport;
  viewport.fit = state[QStringLiteral("fit")].toBool(true);
  viewport.scale = std::clamp(state[QStringLiteral("scale")].toDouble(100), FieldViewport::kMinScale,
                              FieldViewport::kMaxScale);
  viewport.center = {center.at(0).toDouble(), center.at(1).toDouble()};
  viewport.quarterTurns = std::clamp(state[QStringLiteral("quarterTurns")].toInt(), 0, 3);
  canvas_->setViewport(viewport);
}

}  // namespace widgets
