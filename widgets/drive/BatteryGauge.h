// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "robotlink/config/RobotDescription.h"

namespace robotcontrol {
class DriveState;
}

namespace widgets {

/// The charge of a battery and what it means.
struct BatteryLevel {
  /// kUnknown: not reported; kLow: below 20 %, or below the low voltage of its description; kEmpty: below 5
  /// %, or below the empty voltage.
  enum class State : std::uint8_t { kUnknown, kGood, kLow, kEmpty };
  State state = State::kUnknown;
  /// State of charge, 0 to 1; empty if nothing tells it.
  std::optional<double> share;
  double volts = 0;
  /// Whether the robot is being charged.
  bool charging = false;
  bool operator==(const BatteryLevel&) const = default;
  /// Age of the report in s if it is too old to be current.
  std::optional<double> age;

  /// Computes the level. If the base does not report a state of charge, it is estimated from the voltage,
  /// where the robot's description says what its voltages mean. A voltage of 0 is unknown.
  static BatteryLevel of(double volts, std::optional<double> stateOfCharge, bool charging,
                         const std::optional<robotlink::RobotDescription::Battery>& battery);
  /// The same of what a base reports. What it says itself of its voltages counts more than the description.
  static BatteryLevel of(const robotcontrol::DriveState& state,
                         std::optional<robotlink::RobotDescription::Battery> battery);
  /// The level of a battery of which only the state of charge is known, 0 to 1.
  static BatteryLevel ofShare(double share);
  /// "12.4 V, 70 %, charging"; translated.
  QString text() const;
  /// A sentence that says what to do; empty if all is well, the robot is charging, or the report is old.
  QString warning() const;
};

/// A battery symbol with its level and the figures beside it. Object name "baseBattery". GUI thread.
class BatteryGauge final : public QWidget {
  Q_OBJECT
 public:
  explicit BatteryGauge(QWidget* parent = nullptr);
  /// Sets the level.
  void show(const BatteryLevel& level);
  const BatteryLevel& level() const { return level_; }
  /// Pure.
  static void paint(QPainter& painter, const QRectF& rect, const BatteryLevel& level,
                    const QPalette& palette);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {80, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  BatteryLevel level_;
};

}  // namespace widgets
