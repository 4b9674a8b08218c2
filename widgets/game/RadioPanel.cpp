// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/game/RadioPanel.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "widgets/Controls.h"

namespace widgets {

using robotcontrol::TeamRadioSettings;

RadioPanel::RadioPanel(QWidget* parent) : QWidget(parent) {
  struct Number {
    ControlText text;
    QString unit;
    double maximum, step;
    int decimals;
    void (*set)(TeamRadioSettings& settings, double value);
  };
  const std::array<Number, 3> numbers{{
      {{"gameRadioRange", tr("Range"), tr("Range of the radio within a team; 0: unlimited")},
       tr(" m"),
       1000,
       0.5,
       1,
       [](TeamRadioSettings& settings, double value) { settings.set_range(value); }},
      {{"gameRadioDelay", tr("Delay"), tr("Delay of a message")},
       tr(" ms"),
       10000,
       10,
       0,
       [](TeamRadioSettings& settings, double value) { settings.set_delay(value / 1000); }},
      {{"gameRadioLoss", tr("Loss"), tr("Share of lost messages")},
       tr(" %"),
       100,
       1,
       0,
       [](TeamRadioSettings& settings, double value) { settings.set_loss(value / 100); }},
  }};
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Number& number = numbers[i];
    auto* box = boxes_[i] = new QDoubleSpinBox(this);
    describe(*box, number.text);
    box->setDecimals(number.decimals);
    box->setRange(0, number.maximum);
    box->setSingleStep(number.step);
    box->setSuffix(number.unit);
    box->setKeyboardTracking(false);
    auto* label = new QLabel(number.text.text, this);
    label->setBuddy(box);
    row->addWidget(label);
    row->addWidget(box);
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, set = number.set](double value) {
              TeamRadioSettings settings;
              set(settings, value);
              Q_EMIT wanted(settings);
            });
  }
  row->addStretch(1);
}

void RadioPanel::showSettings(const TeamRadioSettings& settings) {
  const std::array<double, 3> values{settings.range(), 1000 * settings.delay(), 100 * settings.loss()};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (boxes_[i]->hasFocus()) continue;
    const QSignalBlocker quiet(boxes_[i]);
    boxes_[i]->setValue(values[i]);
  }
}

}  // namespace widgets
