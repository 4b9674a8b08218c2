// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/SettingsPanel.h"

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "widgets/Controls.h"

namespace widgets {
namespace {

/// The camera confirms a requested value within this time, ms.
constexpr int kAnswerMs = 1500;
/// The most steps of a slider.
constexpr double kMaxSliderSteps = 10000;

using Setting = robotcontrol::CameraSettings::Setting;

double stepOf(const Setting& setting) {
  const double range = setting.maximum() - setting.minimum();
  return std::max(setting.step() > 0 ? setting.step() : range / 100, range / kMaxSliderSteps);
}

int decimalsOf(double step) {
  int decimals = 0;
  for (double rest = step; decimals < 6 && std::abs(rest - std::round(rest)) > 1e-9; ++decimals) rest *= 10;
  return decimals;
}

/// Titles of the simulator's cameras.
[[maybe_unused]] constexpr const char* kTranslatedTitles[]{
    QT_TRANSLATE_NOOP("widgets::SettingsPanel", "Exposure"),
    QT_TRANSLATE_NOOP("widgets::SettingsPanel", "Gain"),
    QT_TRANSLATE_NOOP("widgets::SettingsPanel", "White balance")};

bool isSwitch(const Setting& setting) {
  return setting.minimum() == 0 && setting.maximum() == 1 && setting.step() == 1;
}

}  // namespace

SettingsPanel::SettingsPanel(QWidget* parent) : QWidget(parent) {
  reset = makeAction(this, "reset",
                     {"cameraReset", tr("Reset"),
                      tr("Resets all settings to the values they had when the camera was opened")});
  none_ = makeNote(this, "settingsNone", tr("Why there are no settings"));
  none_->setText(tr("This camera has no settings that can be changed while it takes images."));
  outcome_ = makeNote(this, "settingsOutcome", tr("What came of it"));
  form_ = new QWidget(this);
  auto* buttons = makeToolRow(this);
  buttons->addWidget(makeLabeledButton(this, reset));
  buttons->addStretch(1);
  auto* layout = makeColumn(this, {6, 6, 6, 6}, 4);
  layout->addWidget(none_);
  layout->addWidget(form_);
  layout->addWidget(buttons->parentWidget());
  layout->addWidget(outcome_);
  layout->addStretch(1);
  connect(reset, &QAction::triggered, this, [this] {
    for (std::size_t i = 0; i < rows_.size(); ++i) want(i, rows_[i].setting.initial());
  });
  show(nullptr);
}

void SettingsPanel::show(const robotcontrol::CameraSettings* settings) {
  static const robotcontrol::CameraSettings kNone;
  const auto& now = settings != nullptr ? *settings : kNone;
  const bool isSame = std::equal(rows_.begin(), rows_.end(), now.settings().begin(), now.settings().end(),
                                 [](const Row& row, const Setting& setting) {
                                   return row.setting.name() == setting.name() &&
                                          row.setting.minimum() == setting.minimum() &&
                                          row.setting.maximum() == setting.maximum() &&
                                          row.setting.step() == setting.step();
                                 });
  if (!isSame) rebuild(now);
  none_->setVisible(rows_.empty());
  reset->setEnabled(!rows_.empty());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    row.setting = now.settings(static_cast<int>(i));
    const bool isAwaited = row.changed.isValid() && row.changed.elapsed() < kAnswerMs;
    const bool isHeld = row.slider != nullptr && (row.slider->isSliderDown() || row.number->hasFocus());
    if (!isAwaited && !isHeld) move(row, row.setting.value());
  }
}

void SettingsPanel::rebuild(const robotcontrol::CameraSettings& settings) {
  rows_.clear();
  auto* fresh = new QWidget(this);
  delete layout()->replaceWidget(form_, fresh);
  delete form_;
  form_ = fresh;
  auto* form = new QFormLayout(form_);
  form->setContentsMargins(0, 0, 0, 0);
  rows_.reserve(static_cast<std::size_t>(settings.settings_size()));
  for (const Setting& setting : settings.settings()) addRow(setting);
}

void SettingsPanel::addRow(const Setting& setting) {
  const std::size_t index = rows_.size();
  Row& row = rows_.emplace_back();
  row.setting = setting;
  auto* form = static_cast<QFormLayout*>(form_->layout());
  // In the words of the camera's driver, unless it is one of ours.
  const QString title = tr(setting.title().c_str());
  const QByteArray name = QByteArray("setting/") + setting.name().c_str();
  const double step = stepOf(setting);
  const int decimals = decimalsOf(step);
  const QString tip = tr("%1 to %2; initially %3")
                          .arg(setting.minimum(), 0, 'f', decimals)
                          .arg(setting.maximum(), 0, 'f', decimals)
                          .arg(setting.initial(), 0, 'f', decimals);
  if (isSwitch(setting)) {
    row.box = new QCheckBox(title, form_);
    describe(*row.box, {name.constData(), title, tip});
    form->addRow(row.box);
    connect(row.box, &QCheckBox::toggled, this, [this, index](bool on) { want(index, on ? 1 : 0); });
    return;
  }
  row.number = new QDoubleSpinBox(form_);
  describe(*row.number, {name.constData(), title, tip});
  row.number->setDecimals(decimals);
  row.number->setRange(setting.minimum(), setting.maximum());
  row.number->setSingleStep(step);
  row.number->setKeyboardTracking(false);
  row.slider = new QSlider(Qt::Horizontal, form_);
  describe(*row.slider, {(name + "/slider").constData(), title, tip});
  row.slider->setRange(0, static_cast<int>(std::lround((setting.maximum() - setting.minimum()) / step)));
  row.slider->setPageStep(std::max(1, row.slider->maximum() / 10));
  auto* line = new QHBoxLayout;
  line->addWidget(row.slider, 1);
  line->addWidget(row.number);
  form->addRow(title, line);
  connect(row.number, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this, index](double value) { want(index, value); });
  connect(row.slider, &QSlider::valueChanged, this, [this, index, step](int at) {
    const Setting& of = rows_[index].setting;
    want(index, std::min(of.minimum() + at * step, of.maximum()));
  });
}

void SettingsPanel::move(Row& row, double value) {
  if (row.box != nullptr) {
    const QSignalBlocker quiet(row.box);
    return row.box->setChecked(value != 0);
  }
  const QSignalBlocker quietSlider(row.slider), quietNumber(row.number);
  row.slider->setValue(static_cast<int>(std::lround((value - row.setting.minimum()) / stepOf(row.setting))));
  row.number->setValue(value);
}

void SettingsPanel::want(std::size_t index, double value) {
  Row& row = rows_[index];
  row.changed.start();
  move(row, value);
  Q_EMIT wanted(QString::fromStdString(row.setting.name()), value);
}

}  // namespace widgets
