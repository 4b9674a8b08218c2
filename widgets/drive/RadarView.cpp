// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/RadarView.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/BaseSilence.h"
#include "widgets/Controls.h"
#include "widgets/RobotChoice.h"
#include "widgets/drawings/CurrentDrawings.h"
#include "widgets/drawings/DrawingsModel.h"
#include "widgets/drive/RadarCanvas.h"

namespace widgets {
namespace {

const ViewRegistration kRadarViewRegistration{
    {"radar", QT_TRANSLATE_NOOP("View", "Radar"),
     QT_TRANSLATE_NOOP("View", "What sonars, laser and bumpers of a robot on wheels measure around it."),
     "radar", true, create<RadarView>}};

}  // namespace

RadarView::RadarView(ViewContext& context, QWidget* parent)
    : PictureView(context, "radar", "radar.png", parent) {
  createViews();
  connectSignals();
  keep("northUp", northUp_);
  keep(
      "range", [this] { return canvas_->look().range; },
      [this](const QJsonValue& value) { canvas_->setRange(value.toDouble(RadarLook{}.range)); });
  keep("robot", robots_);
  tick();
}

RadarView::~RadarView() = default;

void RadarView::createViews() {
  northUp_ = makeToggle(this, "north",
                        {"radarNorthUp", tr("Align with map"),
                         tr("Up is the map's y-axis; otherwise the robot's heading"), Qt::Key_N});
  canvas_ = new RadarCanvas(this);
  addToContextMenu(canvas_);
  const Side side = makeDrawings({QStringLiteral("robot")});
  QHBoxLayout* row = makeToolRow(this);
  robots_ = new RobotChoice("radarRobot", row->parentWidget(), RobotChoice::Offer::kOne);
  row->addWidget(robots_);
  row->addStretch(1);
  addButtons(row, {northUp_, zoomOut(), zoomIn(), side.toggle});
  assemble({row->parentWidget()}, canvas_, side, {createFooter()});
}

QWidget* RadarView::createFooter() {
  QHBoxLayout* footer = makeFooter(this);
  time_ = addLabel(footer, "radarTime", tr("Time that is shown"));
  state_ = addLabel(footer, "radarState", tr("Whether the data is old"));
  nearest_ = addLabel(footer, "radarNearest", tr("The nearest obstacles, from sonar and laser"));
  footer->addStretch(1);
  cursor_ = addLabel(footer, "radarCursor", tr("Place under the cursor, seen from the robot"));
  range_ = addLabel(footer, "radarRange", tr("Range shown"));
  return footer->parentWidget();
}

void RadarView::connectSignals() {
  connect(northUp_, &QAction::toggled, canvas_, &RadarCanvas::setNorthUp);
  connect(canvas_, &RadarCanvas::lookChanged, this, &RadarView::updateStatus);
  connect(canvas_, &RadarCanvas::cursorMoved, this, [this](double distance, double angle, bool inside) {
    const int degrees = qRound(robotlink::degrees(angle));
    cursor_->setText(inside ? tr("%1 m at %2°").arg(distance, 0, 'f', 2).arg(degrees) : QString());
  });
  connect(robots_, &RobotChoice::choiceChanged, this, &RadarView::tick);
  connect(drawings(), &DrawingsModel::shownChanged, this, &RadarView::tick);
}

void RadarView::tick() {
  robots_->refresh(session());
  drawings()->refresh(session(), session().selectedRobot());
  const std::string robot = robots_->robot(session());
  subscription_.want(session(), robot,
                     {robotlink::kDriveState.name, robotlink::kSonar.name, robotlink::kLaser.name,
                      robotlink::kRobotPose.name});
  const auto description = context().robots.find(robot);
  const auto memory = robotlink::fromSeconds(canvas_->look().memory);
  RadarReadings readings = radarReadings(
      session().store(), robot, description == context().robots.end() ? nullptr : description->second.get(),
      session().timeline().shown(), memory);
  readings.heading = mapHeading(robot, readings.heading);
  const bool reported = readings.time.has_value();
  auto drawings = drawingsOf(robot);
  // A walking robot has neither sonars nor a laser, but draws what it perceives.
  const bool hasContents = reported || !drawings.empty();
  canvas_->show(std::move(readings), std::move(drawings), hint(robot, hasContents));
  updateStatus();
}

double RadarView::mapHeading(const std::string& robot, double odometry) const {
  const auto* pose = session().store().latestAs<robotcontrol::RobotPose>(
      robot + '/' + robotlink::kRobotPose.name, session().timeline().shown());
  return pose != nullptr ? pose->robot_in_field().heading() : odometry;
}

std::vector<WorldDrawing> RadarView::drawingsOf(const std::string& robot) const {
  std::vector<WorldDrawing> drawings;
  for (const CurrentDrawing& current :
       currentDrawings(session(), robot, this->drawings()->shown(), session().timeline().shown())) {
    const auto* update = dynamic_cast<const foxglove::SceneUpdate*>(current.message.get());
    if (update == nullptr) continue;
    for (const auto& entity : update->entities()) {
      if (entity.frame_id() == robot)
        drawings.push_back(
            {&entity, robotlink::Pose3::Identity(), current.message, current.old, current.id, current.robot});
    }
  }
  return drawings;
}

QString RadarView::hint(const std::string& robot, bool hasContents) const {
  if (robot.empty())
    return tr("No robot. Open a map or scene with robots on wheels, or connect to one (menu Robot).");
  if (hasContents) return {};
  const QString name = QString::fromStdString(robot);
  const auto description = context().robots.find(robot);
  if (description != context().robots.end() && description->second && !description->second->drive)
    return tr("%1 has neither sonars nor a laser. Choose a robot on wheels.").arg(name);
  return tr("Nothing received yet from %1’s sonars and laser. Start the simulation, or switch the robot’s "
            "sonars on.")
      .arg(name);
}

void RadarView::updateStatus() {
  const RadarReadings& readings = canvas_->readings();
  time_->setText(readings.time ? timeText(*readings.time) : QString());
  const QString silence = silenceText(robots_->robot(session()), readings.silence);
  state_->setText(silence);
  state_->setVisible(!silence.isEmpty());
  time_->setVisible(silence.isEmpty());  // there is no room for both
  QStringList nearest;
  if (const auto sonar = readings.nearestSonar()) nearest << tr("sonar %1 m").arg(*sonar, 0, 'f', 2);
  if (const auto laser = readings.nearestLaser()) nearest << tr("laser %1 m").arg(*laser, 0, 'f', 2);
  nearest_->setText(nearest.isEmpty() ? QString()
                                      : tr("nearest: %1").arg(nearest.join(QStringLiteral(", "))));
  range_->setText(tr("%1 m around").arg(canvas_->look().range, 0, 'f', canvas_->look().range < 10 ? 1 : 0));
}

std::optional<QString> RadarView::numbers() {
  const RadarReadings& readings = canvas_->readings();
  QString text = tr("sensor") + QStringLiteral("\t") + tr("number") + QStringLiteral("\t") +
                 tr("distance, m") + QStringLiteral("\tx, m\ty, m\n");
  const auto add = [&text](const QString& sensor, int number, double distance, const robotlink::Vector2& at) {
    text += QStringLiteral("%1\t%2\t%3\t%4\t%5\n")
                .arg(sensor)
                .arg(number)
                .arg(distance, 0, 'f', 4)
                .arg(at.x(), 0, 'f', 4)
                .arg(at.y(), 0, 'f', 4);
  };
  for (const RadarReadings::Echo& echo : readings.echoes) {
    if (!echo.newest || echo.nothing) continue;
    const robotlink::Pose2& from = echo.sensorInRobot;
    add(tr("sonar"), echo.number, echo.range,
        {from.x + echo.range * std::cos(from.heading), from.y + echo.range * std::sin(from.heading)});
  }
  int number = 0;
  for (const robotlink::Vector2& hit : readings.laser)
    add(tr("laser"), number++, (hit - readings.laserInRobot).norm(), hit);
  return text;
}

}  // namespace widgets
