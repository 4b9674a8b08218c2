// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/LightMenu.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QWidgetAction>
#include <cmath>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

constexpr int kStepsPerUnit = 100;
constexpr int kRefreshMs = 100;
/// The number of the simulation's reports in which a requested light may be missing.
constexpr int kPatience = 10;

}  // namespace

double LightMenu::Control::value() const {
  return box->value();
}

void LightMenu::Control::show(double value) const {
  const QSignalBlocker silentSlider(slider), silentBox(box);
  if (!slider->isSliderDown()) slider->setValue(static_cast<int>(std::lround(value * kStepsPerUnit)));
  if (!box->hasFocus() && box->value() != value) box->setValue(value);
}

LightMenu::LightMenu(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QMenu(tr("&Light"), parent), workbench_(workbench), actions_(actions) {
  setObjectName(QStringLiteral("lightMenu"));
  setToolTipsVisible(true);
  createPanel();
  addSeparator();
  createNamedLights();
  refreshing_.setInterval(kRefreshMs);
  connect(&refreshing_, &QTimer::timeout, this, &LightMenu::refresh);
  connect(this, &QMenu::aboutToShow, this, [this] {
    refresh();
    refreshing_.start();
  });
  connect(this, &QMenu::aboutToHide, &refreshing_, &QTimer::stop);
}

void LightMenu::createPanel() {
  auto* panel = new QWidget(this);
  auto* grid = new QGridLayout(panel);
  brightness_ = createControl(*grid, {"lightBrightness",
                                      tr("Brightness"),
                                      tr("Brightness of all light, relative to the scene's"),
                                      0,
                                      10,
                                      3,
                                      {tr("0"), tr("1"), tr("2"), tr("3")}});
  brightness_.box->setSuffix(tr(" ×"));
  warmth_ =
      createControl(*grid, {"lightWarmth",
                            tr("Warmth"),
                            tr("Color of all light: above 0 reddish like bulbs, below 0 bluish like the sky"),
                            -1,
                            1,
                            1,
                            {tr("bluish"), tr("0"), tr("reddish")}});
  auto* action = new QWidgetAction(this);
  action->setDefaultWidget(panel);
  addAction(action);
}

LightMenu::Control LightMenu::createControl(QGridLayout& grid, const Range& range) {
  constexpr int kSliderWidth = 240, kTicksPerUnit = 4;
  Control control{new QSlider(Qt::Horizontal), new QDoubleSpinBox};
  auto* label = new QLabel(range.label);
  label->setBuddy(control.box);
  control.slider->setObjectName(QLatin1String(range.name) + QStringLiteral("Slider"));
  control.slider->setAccessibleName(range.label);
  control.slider->setRange(static_cast<int>(range.least * kStepsPerUnit),
                           static_cast<int>(range.slidesTo * kStepsPerUnit));
  control.slider->setTickPosition(QSlider::TicksBelow);
  control.slider->setTickInterval(kStepsPerUnit / kTicksPerUnit);
  control.slider->setSingleStep(kStepsPerUnit / 20);
  control.slider->setPageStep(kStepsPerUnit / kTicksPerUnit);
  control.slider->setMinimumWidth(kSliderWidth);
  control.box->setObjectName(QLatin1String(range.name));
  control.box->setRange(range.least, range.greatest);
  control.box->setSingleStep(0.05);
  control.box->setKeyboardTracking(false);
  for (QWidget* widget : {static_cast<QWidget*>(control.slider), static_cast<QWidget*>(control.box)})
    widget->setToolTip(range.toolTip);
  auto* marks = new QHBoxLayout;
  for (const QString& mark : range.marks) {
    if (mark != range.marks.front()) marks->addStretch(1);
    marks->addWidget(new QLabel(mark));
  }
  const int row = grid.rowCount();
  grid.addWidget(label, row, 0);
  grid.addWidget(control.slider, row, 1);
  grid.addWidget(control.box, row, 2);
  grid.addLayout(marks, row + 1, 1);
  connect(control.slider, &QSlider::valueChanged, this,
          [control](int value) { control.box->setValue(static_cast<double>(value) / kStepsPerUnit); });
  connect(control.box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this, control](double value) {
            const QSignalBlocker silent(control.slider);
            control.slider->setValue(static_cast<int>(std::lround(value * kStepsPerUnit)));
            choose();
          });
  return control;
}

void LightMenu::createNamedLights() {
  const struct {
    QString text;
    const char* name;
    double brightness, warmth;
  } lights[] = {{tr("As in the &scene"), "light.scene", 1, 0},
                {tr("&Brighter"), "light.bright", 1.3, 0},
                {tr("&Darker"), "light.dark", 0.6, 0},
                {tr("&Warmer"), "light.warm", 1, 0.25},
                {tr("&Cooler"), "light.cool", 1, -0.25},
                {tr("Darker and w&armer"), "light.dark-warm", 0.75, 0.25}};
  for (const auto& light : lights) {
    QAction* action = addAction(
        light.text, this,
        [this, values = std::vector<robotlink::CommandTable::Value>{light.brightness, light.warmth}] {
          actions_.run(QStringLiteral("simulation.light"), values);
        });
    action->setObjectName(QLatin1String(light.name));
    action->setToolTip(tr("Brightness %1, warmth %2").arg(light.brightness).arg(light.warmth));
  }
}

void LightMenu::choose() {
  asked_ = Light(brightness_.value(), warmth_.value());
  patience_ = kPatience;
  actions_.run(QStringLiteral("simulation.light"), {asked_->first, asked_->second});
}

void LightMenu::refresh() {
  auto& session = workbench_.session();
  const auto* status = session.store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, session.timeline().newest());
  const bool simulated =
      status != nullptr && workbench_.loaded() != nullptr && workbench_.loaded()->isSimulated();
  for (QAction* action : actions()) action->setEnabled(simulated);
  if (!simulated) return;
  const Light reported(status->brightness(), status->warmth());
  // A recent request may not have arrived yet.
  if (asked_ && reported != *asked_ && --patience_ > 0) return;
  asked_.reset();
  brightness_.show(reported.first);
  warmth_.show(reported.second);
}

}  // namespace app
