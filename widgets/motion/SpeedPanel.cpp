// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/SpeedPanel.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>

#include "widgets/Controls.h"

namespace widgets {

SpeedPanel::SpeedPanel(QWidget* parent) : QGroupBox(tr("Speed"), parent) {
  setObjectName(QStringLiteral("speedPanel"));
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setVerticalSpacing(2);
  createTable();
  createLimits();
}

void SpeedPanel::createTable() {
  auto* layout = static_cast<QGridLayout*>(this->layout());
  const QString columns[] = {tr("forward\nmm/s"), tr("left\nmm/s"), tr("turn\nrad/s")};
  const QString rows[] = {tr("asked"), tr("true"), tr("believed")};
  const QString tips[] = {tr("What you request"),
                          tr("How the robot really moved in the last half second (from the simulator)"),
                          tr("What the robot reports (motion/status, drive/state)")};
  const char* names[] = {"speedAsked", "speedMeasured", "speedBelieved"};
  const char* axes[] = {"X", "Y", "Turn"};
  for (int column = 0; column < 3; ++column) {
    auto* head = new QLabel(columns[column], this);
    head->setAlignment(Qt::AlignRight);
    head->setEnabled(false);
    if (column == 1) sideways_ = head;
    layout->addWidget(head, 0, column + 1);
    layout->setColumnStretch(column + 1, 1);
  }
  for (int row = 0; row < kRows; ++row) {
    auto* title = new QLabel(rows[row], this);
    title->setToolTip(tips[row]);
    layout->addWidget(title, row + 1, 0);
    for (int column = 0; column < 3; ++column) {
      auto* cell = new QLabel(QStringLiteral("–"), this);
      cell->setObjectName(QString::fromLatin1(names[row]) + QString::fromLatin1(axes[column]));
      cell->setAccessibleName(rows[row] + QLatin1Char(' ') + columns[column]);
      cell->setAlignment(Qt::AlignRight);
      layout->addWidget(cell, row + 1, column + 1);
      cells_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = cell;
    }
  }
}

void SpeedPanel::createLimits() {
  speed_ = new QDoubleSpinBox(this);
  describe(*speed_, {"limitSpeed", tr("Maximum speed"), tr("Speed at full deflection")});
  speed_->setRange(10, 1000);
  speed_->setDecimals(0);
  speed_->setSingleStep(10);
  speed_->setSuffix(tr(" mm/s"));
  rotation_ = new QDoubleSpinBox(this);
  describe(*rotation_, {"limitRotation", tr("Maximum turn"), tr("Turning speed at full deflection")});
  rotation_->setRange(0.1, 10);
  rotation_->setSingleStep(0.1);
  rotation_->setSuffix(tr(" rad/s"));
  setLimits({});
  auto* layout = static_cast<QGridLayout*>(this->layout());
  layout->addWidget(new QLabel(tr("limits"), this), kRows + 1, 0);
  layout->addWidget(speed_, kRows + 1, 1, 1, 2);
  layout->addWidget(rotation_, kRows + 1, 3);
  for (auto* box : {speed_, rotation_}) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &SpeedPanel::limitsChanged);
  }
}

void SpeedPanel::setRobot(bool wheels, const MotionCommander::Limits& greatest) {
  sideways_->setVisible(!wheels);
  for (const auto& row : cells_) row[1]->setVisible(!wheels);
  speed_->setMaximum(greatest.speed * 1000);
  rotation_->setMaximum(greatest.rotation);
  speed_->setSingleStep(wheels ? 50 : 10);
}

void SpeedPanel::showRow(Row row, const std::optional<Speed>& speed) {
  const auto& cells = cells_[row];
  const auto text = [&](double value, int digits) {
    QString shown = QString::number(value, 'f', digits);
    if (shown.toDouble() == 0) shown.remove(QLatin1Char('-'));
    return speed ? shown : QStringLiteral("–");
  };
  const Speed value = speed.value_or(Speed{});
  cells[0]->setText(text(value.x * 1000, 0));
  cells[1]->setText(text(value.y * 1000, 0));
  cells[2]->setText(text(value.rotation, 2));
}

void SpeedPanel::showSpeeds(const Speed& asked, const std::optional<Speed>& measured,
                            const std::optional<Speed>& believed) {
  showRow(kAsked, asked);
  showRow(kMeasured, measured);
  showRow(kBelieved, believed);
}

MotionCommander::Limits SpeedPanel::limits() const {
  return {speed_->value() / 1000, rotation_->value()};
}

void SpeedPanel::setLimits(const MotionCommander::Limits& limits) {
  speed_->setValue(limits.speed * 1000);
  rotation_->setValue(limits.rotation);
}

}  // namespace widgets
