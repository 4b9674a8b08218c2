// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/BatteryGauge.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "robotcontrol/Driving.pb.h"
#include "widgets/Controls.h"
#include "widgets/Theme.h"

namespace widgets {
namespace {

constexpr double kEmptyShare = 0.05, kLowShare = 0.2;

QColor colorFor(BatteryLevel::State state, const QPalette& palette) {
  switch (state) {
    case BatteryLevel::State::kGood:
      return colorOf(Meaning::kGood, palette);
    case BatteryLevel::State::kLow:
      return colorOf(Meaning::kWarning, palette);
    case BatteryLevel::State::kEmpty:
      return colorOf(Meaning::kBad, palette);
    case BatteryLevel::State::kUnknown:
      break;
  }
  return colorOf(Meaning::kMuted, palette);
}

struct BatteryText {
  Q_DECLARE_TR_FUNCTIONS(BatteryGauge)
};

}  // namespace

BatteryLevel BatteryLevel::of(double volts, std::optional<double> stateOfCharge, bool charging,
                              const std::optional<robotlink::RobotDescription::Battery>& battery) {
  BatteryLevel level;
  level.volts = volts;
  level.charging = charging;
  if (!(volts > 0)) return level;
  level.share = stateOfCharge;
  if (!level.share && battery && battery->full > battery->empty)
    level.share = (volts - battery->empty) / (battery->full - battery->empty);
  if (level.share) level.share = std::clamp(*level.share, 0.0, 1.0);
  const bool empty = (battery && volts < battery->empty) || (stateOfCharge && *stateOfCharge < kEmptyShare);
  const bool low = (battery && volts < battery->low) || (stateOfCharge && *stateOfCharge < kLowShare);
  level.state = empty ? State::kEmpty : low ? State::kLow : State::kGood;
  return level;
}

BatteryLevel BatteryLevel::of(const robotcontrol::DriveState& state,
                              std::optional<robotlink::RobotDescription::Battery> battery) {
  if (state.has_battery_low() || state.has_battery_empty()) {
    if (!battery) battery = robotlink::RobotDescription::Battery();
    if (state.has_battery_low()) battery->low = state.battery_low();
    if (state.has_battery_empty()) battery->empty = state.battery_empty();
  }
  return of(state.battery(),
            state.has_state_of_charge() ? std::optional(state.state_of_charge()) : std::nullopt,
            state.charging() == robotcontrol::DriveState::CHARGING, battery);
}

BatteryLevel BatteryLevel::ofShare(double share) {
  BatteryLevel level;
  level.share = std::clamp(share, 0.0, 1.0);
  level.state = share < kEmptyShare ? State::kEmpty : share < kLowShare ? State::kLow : State::kGood;
  return level;
}

QString BatteryLevel::text() const {
  if (state == State::kUnknown) return BatteryText::tr("unknown");
  if (!(volts > 0) && share) return BatteryText::tr("%1 %").arg(qRound(*share * 100));
  const QString text = share ? BatteryText::tr("%1 V, %2 %").arg(volts, 0, 'f', 1).arg(qRound(*share * 100))
                             : BatteryText::tr("%1 V").arg(volts, 0, 'f', 1);
  if (age) return BatteryText::tr("%1, %2 s ago").arg(text).arg(*age, 0, 'f', 0);
  return charging ? BatteryText::tr("%1, charging").arg(text) : text;
}

QString BatteryLevel::warning() const {
  if (charging || age) return {};
  if (state == State::kEmpty) return BatteryText::tr("The battery is empty: charge it now.");
  if (state == State::kLow) return BatteryText::tr("The battery is low: charge it soon.");
  return {};
}

BatteryGauge::BatteryGauge(QWidget* parent) : QWidget(parent) {
  describe(*this, {"baseBattery", tr("Battery"), tr("Voltage and level of the robot's battery")});
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize BatteryGauge::sizeHint() const {
  return {180, fontMetrics().height() + 4};
}

void BatteryGauge::show(const BatteryLevel& level) {
  level_ = level;
  setAccessibleDescription(level.text() + QLatin1Char(' ') + level.warning());
  update();
}

void BatteryGauge::paint(QPainter& painter, const QRectF& rect, const BatteryLevel& level,
                         const QPalette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor muted = colorOf(Meaning::kMuted, palette);
  const QColor color = level.age ? muted : colorFor(level.state, palette);
  const QRectF body(rect.left() + 1, rect.top() + 2, 34, rect.height() - 4);
  painter.setPen(QPen(palette.color(QPalette::WindowText), 1.2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(body, 2, 2);
  painter.setBrush(palette.color(QPalette::WindowText));
  painter.drawRect(QRectF(body.right() + 0.6, body.center().y() - body.height() / 5, 2, body.height() / 2.5));
  if (level.share) {
    QRectF filled = body.adjusted(2.5, 2.5, -2.5, -2.5);
    filled.setWidth(std::max(1.5, filled.width() * *level.share));
    painter.fillRect(filled, color);
  }
  const bool plain =
      level.age || level.state == BatteryLevel::State::kGood || level.state == BatteryLevel::State::kUnknown;
  QFont font = painter.font();
  font.setBold(!plain);
  painter.setFont(font);
  painter.setPen(plain && !level.age ? palette.color(QPalette::WindowText) : color);
  const QRectF beside(body.right() + 9, rect.top(), rect.right() - body.right() - 9, rect.height());
  painter.drawText(beside, Qt::AlignVCenter | Qt::AlignLeft, level.text());
  painter.restore();
}

void BatteryGauge::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter, rect(), level_, palette());
}

}  // namespace widgets
