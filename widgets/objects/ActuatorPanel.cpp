// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/ActuatorPanel.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "robotcontrol/World.pb.h"
#include "widgets/Controls.h"
#include "widgets/Requests.h"
#include "widgets/objects/SceneTreeModel.h"
#include "widgets/ports/PortNumber.h"

namespace widgets {
namespace {

constexpr int kActuatorSteps = 1000;
/// The range of an actuator that names none.
constexpr double kUnknownRange = 1000;

/// The name of a value of an actuator with several values.
QString valueName(const robotcontrol::WorldPort& port, int value) {
  if (port.type() == "wheel_speeds")
    return value == 0 ? ActuatorPanel::tr("left") : ActuatorPanel::tr("right");
  const QString ahead = ActuatorPanel::tr("ahead"), left = ActuatorPanel::tr("left"),
                turn = ActuatorPanel::tr("turn");
  if (port.type() == "motion" && port.shape_size() == 1) {
    const QStringList names = port.shape(0) == 3   ? QStringList{ahead, left, turn}
                              : port.shape(0) == 6 ? QStringList{ahead,
                                                                 left,
                                                                 ActuatorPanel::tr("up"),
                                                                 ActuatorPanel::tr("roll"),
                                                                 ActuatorPanel::tr("pitch"),
                                                                 turn}
                              : port.unit().ends_with(", rad")
                                  ? QStringList{ahead, ActuatorPanel::tr("steering")}
                                  : QStringList{left, ActuatorPanel::tr("right")};
    if (value < names.size()) return names[value];
  }
  return QString::number(value);
}

}  // namespace

ActuatorPanel::ActuatorPanel(robotlink::Session& session, const SceneTreeModel& model, QWidget* parent)
    : QWidget(parent), session_(session), model_(model) {
  setObjectName(QStringLiteral("actuatorPanel"));
  release_ = new QPushButton(tr("Release"), this);
  describe(*release_,
           {"actuatorsRelease", tr("Release"), tr("Lets the robots' programs set these actuators again")});
  outcome_ = makeNote(this, "actuatorsOutcome", tr("Whether the actuators could be set"));
  area_ = makeScrollArea(this, new QWidget);
  auto* row = new QHBoxLayout;
  row->addWidget(outcome_, 1);
  row->addWidget(release_);
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(area_);
  layout->addLayout(row);
  connect(release_, &QPushButton::clicked, this, &ActuatorPanel::release);
  hide();
}

ActuatorPanel::~ActuatorPanel() = default;

void ActuatorPanel::show(std::vector<std::string> actuators) {
  if (actuators.size() > kMax) actuators.resize(kMax);
  if (actuators == shown_ && !rows_.empty()) return;
  shown_ = std::move(actuators);
  rows_.clear();
  outcome_->clear();
  contents_ = new QWidget;
  grid_ = new QGridLayout(contents_);
  grid_->setContentsMargins({});
  grid_->setColumnStretch(1, 1);
  for (const std::string& path : shown_)
    if (const auto* object = model_.object(path); object != nullptr && object->has_port())
      addActuator(*object);
  area_->setWidget(contents_);  // deletes the one before
  setVisible(!rows_.empty());
  refresh();
}

void ActuatorPanel::addActuator(const robotcontrol::WorldObject& object) {
  constexpr int kMaxValues = 16;
  const int values = std::clamp(numberCount(object.port()), 1, kMaxValues);
  for (int i = 0; i < values; ++i) addRow(object, i, values);
}

void ActuatorPanel::addRow(const robotcontrol::WorldObject& object, int value, int values) {
  const robotcontrol::WorldPort& port = object.port();
  const PortNumber number = portNumber(object, value);
  Row row{port.path(), port.robot(), value, number.hasRange() ? number.minimum : -kUnknownRange,
          number.hasRange() ? number.maximum : kUnknownRange};
  const QString path = QString::fromStdString(port.path());
  const QString name = values == 1 ? path : QStringLiteral("%1 [%2]").arg(path, valueName(port, value));
  const QString unit = QString::fromStdString(number.unit);
  const QByteArray suffix = (path + QLatin1Char('-') + QString::number(value)).toUtf8();
  row.slider = new QSlider(Qt::Horizontal, contents_);
  row.slider->setRange(0, kActuatorSteps);
  row.slider->setPageStep(kActuatorSteps / 20);
  describe(*row.slider, {QByteArray("actuator-" + suffix).constData(), name,
                         tr("Holds %1 between %2 and %3 %4")
                             .arg(name)
                             .arg(row.minimum, 0, 'g', 4)
                             .arg(row.maximum, 0, 'g', 4)
                             .arg(unit)});
  row.field = new QDoubleSpinBox(contents_);
  row.field->setDecimals(3);
  row.field->setRange(row.minimum, row.maximum);
  row.field->setSingleStep((row.maximum - row.minimum) / 100);
  row.field->setKeyboardTracking(false);
  if (!unit.isEmpty()) row.field->setSuffix(QLatin1Char(' ') + unit);
  describe(*row.field, {QByteArray("actuatorValue-" + suffix).constData(), name, tr("The value to hold")});
  const int line = grid_->rowCount();
  grid_->addWidget(new QLabel(name, contents_), line, 0);
  grid_->addWidget(row.slider, line, 1);
  grid_->addWidget(row.field, line, 2);
  if (value == 0) {
    row.blocked = new QLabel(tr("blocked"), contents_);
    describe(*row.blocked,
             {QByteArray("actuatorBlocked-" + path.toUtf8()).constData(), tr("Blocked: %1").arg(path),
              tr("It has hit an obstacle since its last command")});
    QSizePolicy kept = row.blocked->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    row.blocked->setSizePolicy(kept);
    row.blocked->hide();
    grid_->addWidget(row.blocked, line, 3);
  }
  connect(row.slider, &QSlider::valueChanged, this, [this, row](int step) {
    if (isRefreshing_) return;
    const QSignalBlocker blocker(row.field);
    row.field->setValue(row.minimum + (row.maximum - row.minimum) * step / kActuatorSteps);
    hold(row.port);
  });
  connect(row.field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, row](double wanted) {
    if (isRefreshing_) return;
    const QSignalBlocker blocker(row.slider);
    row.slider->setValue(stepOf(row, wanted));
    hold(row.port);
  });
  rows_.push_back(row);
}

double ActuatorPanel::present(const Row& row) const {
  constexpr std::array<std::pair<std::string_view, const char*>, 4> kSiblings{{{"/request", "/position"},
                                                                               {"/speed_request", "/speed"},
                                                                               {"/torque_request", "/load"},
                                                                               {"/force_request", "/load"}}};
  for (const auto& [request, measured] : kSiblings) {
    if (!row.port.ends_with(request)) continue;
    const std::string sensor = row.port.substr(0, row.port.size() - request.size()) + measured;
    if (const auto* reading = model_.reading(sensor); reading != nullptr && reading->values_size() > 0)
      return reading->values(0);
  }
  return 0;
}

int ActuatorPanel::stepOf(const Row& row, double value) {
  return static_cast<int>(std::lround(kActuatorSteps * (value - row.minimum) / (row.maximum - row.minimum)));
}

bool ActuatorPanel::isBlocked(const std::string& port) const {
  const auto* state = model_.reading(port);
  // Whether the command was reached, and whether nothing was in the way.
  return state != nullptr && state->values_size() == 2 && state->values(1) == 0;
}

void ActuatorPanel::refresh() {
  if (isVisible()) subscription_.want(session_, shown_);
  isRefreshing_ = true;
  bool isAnyHeld = false;
  for (const Row& row : rows_) {
    const auto* held = model_.held(row.port);
    if (row.blocked != nullptr) row.blocked->setVisible(isBlocked(row.port));
    isAnyHeld = isAnyHeld || held != nullptr;
    QFont font = row.field->font();
    font.setBold(held != nullptr);
    row.field->setFont(font);
    if (row.slider->isSliderDown() || row.field->hasFocus() || row.slider->hasFocus()) continue;
    const bool hasValue = held != nullptr && row.value < held->values_size();
    const double value =
        hasValue ? held->values(row.value) : std::clamp(present(row), row.minimum, row.maximum);
    row.slider->setValue(stepOf(row, value));
    row.field->setValue(value);
  }
  release_->setEnabled(isAnyHeld);
  isRefreshing_ = false;
}

void ActuatorPanel::hold(const std::string& port) {
  robotcontrol::Request request;
  std::string robot;
  request.mutable_set_actuator()->set_port(port);
  for (const Row& row : rows_) {
    if (row.port != port) continue;
    robot = row.robot;
    request.mutable_set_actuator()->add_values(row.field->value());
  }
  send(robot, std::move(request));
}

void ActuatorPanel::release() {
  std::set<std::string> done;
  for (const Row& row : rows_) {
    if (!done.insert(row.port).second) continue;
    robotcontrol::Request request;
    request.mutable_set_actuator()->set_port(row.port);
    request.mutable_set_actuator()->set_released(true);
    send(row.robot, std::move(request));
  }
}

void ActuatorPanel::send(const std::string& robot, robotcontrol::Request request) {
  // Models that are no robots, such as doors, belong to the simulation.
  const auto& robots = session_.robots();
  const bool isRobot = std::ranges::find(robots, robot) != robots.end();
  ask(session_, isRobot ? robot : std::string(), std::move(request), this,
      [this](bool accepted, const QString& reason) {
        showOutcome(*outcome_, accepted ? QString() : reason, !accepted);
      });
}

}  // namespace widgets
