// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/TrainingPanel.h"

#include <QAction>
#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "colortool/correction/CorrectionEstimate.h"
#include "widgets/Controls.h"
#include "widgets/color/ColorBench.h"

namespace widgets {
namespace {

using colortool::TrainingOption;

constexpr int kSliderSteps = 400;

/// The texts of a numeric option.
struct NumberText {
  const char* option;
  const char* title;
  const char* toolTip;
  int decimals;
};
constexpr NumberText kNumbers[] = {
    {"radius", QT_TRANSLATE_NOOP("TrainingPanel", "Radius"),
     QT_TRANSLATE_NOOP("TrainingPanel", "How far a sample reaches in Cb and Cr, in values of a channel"), 1},
    {"brightness-weight", QT_TRANSLATE_NOOP("TrainingPanel", "Brightness"),
     QT_TRANSLATE_NOOP(
         "TrainingPanel",
         "Weight of a difference in Y, relative to Cb or Cr; small: light and shadow matter less"),
     2},
    {"rejection", QT_TRANSLATE_NOOP("TrainingPanel", "Rejection"),
     QT_TRANSLATE_NOOP("TrainingPanel", "Minimum votes for a class; larger: more colors have no class"), 3},
    {"background-weight", QT_TRANSLATE_NOOP("TrainingPanel", "Background"),
     QT_TRANSLATE_NOOP("TrainingPanel", "Weight of a background sample, relative to one of a class"), 2},
    {"shading", QT_TRANSLATE_NOOP("TrainingPanel", "Shade"),
     QT_TRANSLATE_NOOP("TrainingPanel",
                       "How much a sample supports its color in shadow and glare, where no other is near"),
     2},
    {"gray-guard", QT_TRANSLATE_NOOP("TrainingPanel", "Gray guard"),
     QT_TRANSLATE_NOOP("TrainingPanel",
                       "Confidence that nearly gray colors, like those of walls and shadows, need to count "
                       "as ball, goal or robot"),
     1},
    {"gaussian-distance", QT_TRANSLATE_NOOP("TrainingPanel", "Distance²"),
     QT_TRANSLATE_NOOP("TrainingPanel", "Squared Mahalanobis distance beyond which a color has no class"), 1},
    {"cost", QT_TRANSLATE_NOOP("TrainingPanel", "Cost"),
     QT_TRANSLATE_NOOP("TrainingPanel",
                       "Cost of a misclassified sample; larger: follows single samples more closely"),
     1},
    {"gamma", QT_TRANSLATE_NOOP("TrainingPanel", "Gamma"),
     QT_TRANSLATE_NOOP("TrainingPanel", "How narrow the functions around samples are; larger: narrower"), 6},
    {"distance", QT_TRANSLATE_NOOP("TrainingPanel", "Distance"),
     QT_TRANSLATE_NOOP("TrainingPanel", "A color farther than this from all samples has no class"), 1}};

QString trainingText(const char* text) {
  return QCoreApplication::translate("TrainingPanel", text);
}

/// Conversion between values and slider positions, 0 to kSliderSteps.
int sliderPosition(const TrainingOption& option, double value) {
  const double share = option.logarithmic
                           ? std::log(value / option.least) / std::log(option.most / option.least)
                           : (value - option.least) / (option.most - option.least);
  return static_cast<int>(std::lround(kSliderSteps * std::clamp(share, 0.0, 1.0)));
}
double sliderValue(const TrainingOption& option, int position) {
  const double share = static_cast<double>(position) / kSliderSteps;
  return option.logarithmic ? option.least * std::pow(option.most / option.least, share)
                            : option.least + share * (option.most - option.least);
}
double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

}  // namespace

TrainingPanel::TrainingPanel(ColorBench& bench, QWidget* parent) : QWidget(parent), bench_(bench) {
  setObjectName(QStringLiteral("trainingPanel"));
  createViews();
  connectSignals();
  showSettings();
}

void TrainingPanel::createViews() {
  method_ = new QComboBox(this);
  describe(*method_, {"trainingMethod", tr("Method"), tr("How the table is made from the samples")});
  method_->addItem(tr("Kernel votes"));
  method_->setItemData(
      0, tr("Samples vote for the colors around them; the fastest, and good from the first stroke on"),
      Qt::ToolTipRole);
  method_->addItem(tr("Gaussians"));
  method_->setItemData(1, tr("One Gaussian per class; smooth, and good from ten strokes on"),
                       Qt::ToolTipRole);
  method_->addItem(tr("Support vectors"));
  method_->setItemData(2, tr("A support vector machine; slower"), Qt::ToolTipRole);
  defaults_ = makeAction(
      this, "reset",
      {"trainingDefaults", tr("Defaults"), tr("Resets the method and all options to their defaults")});
  auto* top = new QHBoxLayout;
  top->addWidget(method_, 1);
  top->addWidget(makeButton(this, defaults_));

  auto* grid = new QGridLayout;
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  for (const NumberText& text : kNumbers) {
    Control control{colortool::findTrainingOption(text.option), trainingText(text.title)};
    addNumber(*grid, std::move(control), trainingText(text.toolTip));
    controls_.back().field->setDecimals(text.decimals);
  }
  auto* switches = new QGridLayout;
  switches->setVerticalSpacing(2);
  switches->addWidget(addSwitch("remove-unsupported", tr("Remove strays"),
                                tr("Colors of a class that are far from all its samples lose it")),
                      0, 0);
  switches->addWidget(addSwitch("fill-holes", tr("Fill holes"),
                                tr("Unclassified colors that one class encloses are assigned to it")),
                      0, 1);
  switches->addWidget(addSwitch("correct-vignetting", tr("Correct vignetting"),
                                tr("Removes the lens's darkening of the corners before the table is used")),
                      1, 0);
  switches->addWidget(
      addSwitch("correct-cameras", tr("Correct cameras"), tr("Matches the colors of all cameras")), 1, 1);

  estimate_ = makeAction(
      this, "labels",
      {"estimateCorrections", tr("Estimate"),
       tr("Estimates from the strokes how the lens and the cameras change colors, and corrects it")});
  auto* estimate = makeButton(this, estimate_);
  estimate->setToolButtonStyle(Qt::ToolButtonTextOnly);
  switches->addWidget(estimate, 1, 2);
  switches->setColumnStretch(0, 1);
  switches->setColumnStretch(1, 1);
  auto* layout = makeColumn(this, {}, 4);
  layout->addLayout(top);
  layout->addLayout(grid);
  layout->addLayout(switches);
}

void TrainingPanel::addNumber(QGridLayout& grid, Control control, const QString& toolTip) {
  const QByteArray name(control.option->name.data(), static_cast<int>(control.option->name.size()));
  const int row = grid.rowCount();
  control.label = new QLabel(control.title, this);
  control.slider = new QSlider(Qt::Horizontal, this);
  describe(*control.slider, {(name + "-slider").constData(), control.title, toolTip});
  control.slider->setRange(0, kSliderSteps);
  control.slider->setPageStep(kSliderSteps / 10);
  control.field = new QDoubleSpinBox(this);
  describe(*control.field, {name.constData(), control.title, toolTip});
  control.field->setRange(control.option->least, control.option->most);
  control.field->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  control.field->setKeyboardTracking(false);
  control.label->setBuddy(control.field);
  control.label->setToolTip(toolTip);
  grid.addWidget(control.label, row, 0);
  grid.addWidget(control.slider, row, 1);
  grid.addWidget(control.field, row, 2);
  controls_.push_back(std::move(control));
}

QCheckBox* TrainingPanel::addSwitch(const char* name, const QString& title, const QString& toolTip) {
  auto* box = new QCheckBox(title, this);
  describe(*box, {name, title, toolTip});
  Control control{colortool::findTrainingOption(name), title};
  control.box = box;
  controls_.push_back(std::move(control));
  return box;
}

void TrainingPanel::connectControl(const Control& control) {
  if (control.box != nullptr) {
    connect(control.box, &QCheckBox::toggled, this, [this, control](bool on) { set(control, on ? 1 : 0); });
    return;
  }
  connect(control.slider, &QSlider::valueChanged, this, [this, control](int position) {
    set(control, rounded(sliderValue(*control.option, position), control.field->decimals()));
  });
  connect(control.field, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this, control](double value) { set(control, value); });
  connect(control.slider, &QSlider::sliderPressed, this, &TrainingPanel::endGesture);
  connect(control.slider, &QSlider::sliderReleased, this, &TrainingPanel::endGesture);
  connect(control.field, &QDoubleSpinBox::editingFinished, this, &TrainingPanel::endGesture);
}

void TrainingPanel::connectSignals() {
  for (const Control& control : controls_) connectControl(control);
  connect(method_, qOverload<int>(&QComboBox::activated), this, &TrainingPanel::setMethod);
  connect(defaults_, &QAction::triggered, this, [this] {
    colortool::Samples next = bench_.samples();
    next.settings = {};
    bench_.change(tr("Default options"), std::move(next));
  });
  connect(estimate_, &QAction::triggered, this, &TrainingPanel::estimate);
  connect(&bench_, &ColorBench::samplesChanged, this, &TrainingPanel::showSettings);
}

void TrainingPanel::setMethod(int index) {
  colortool::Samples next = bench_.samples();
  next.settings.method = static_cast<colortool::TrainingMethod>(index);
  bench_.change(tr("Method: %1").arg(method_->itemText(index)), std::move(next));
}

void TrainingPanel::estimate() {
  auto found = colortool::estimateCorrections(bench_.samples());
  colortool::Samples next = bench_.samples();
  next.corrections = std::move(found.corrections);
  // The estimate is switched on at once; if nothing could be estimated nothing changes.
  const bool any = !next.corrections.empty();
  next.settings.correctVignetting = next.settings.correctVignetting || any;
  next.settings.correctCameras = next.settings.correctCameras || any;
  bench_.change(tr("Estimate corrections"), std::move(next));
  QStringList notes;
  for (const std::string& note : found.notes) notes << QString::fromStdString(note);
  Q_EMIT reported(notes.join(QLatin1Char('\n')));
}

void TrainingPanel::set(const Control& control, double value) {
  if (showing_) return;
  colortool::Samples next = bench_.samples();
  control.option->set(next.settings, std::clamp(value, control.option->least, control.option->most));
  const std::string gesture =
      control.box != nullptr ? std::string()
                             : "option " + std::string(control.option->name) + " " + std::to_string(gesture_);
  bench_.change(control.title, std::move(next), gesture);
}

void TrainingPanel::showSettings() {
  showing_ = true;
  const colortool::TrainingSettings& settings = bench_.samples().settings;
  method_->setCurrentIndex(static_cast<int>(settings.method));
  for (const Control& control : controls_) {
    const double value = control.option->get(settings);
    if (control.box != nullptr) {
      control.box->setChecked(value != 0);
      continue;
    }
    const bool mine = control.option->method == settings.method;
    control.label->setVisible(mine);
    control.slider->setVisible(mine);
    control.field->setVisible(mine);
    // A slider that is being dragged stays under the mouse, even if its value was rounded.
    if (!control.slider->isSliderDown()) control.slider->setValue(sliderPosition(*control.option, value));
    control.field->setValue(value);
  }
  defaults_->setEnabled(settings != colortool::TrainingSettings{});
  showing_ = false;
}

}  // namespace widgets
