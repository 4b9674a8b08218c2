// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

namespace widgets {

/// How full a battery is, and what that means.
struct BatteryLevel {
  enum class State : std::uint8_t { kUnknown, kGood, kLow, kEmpty };
  State state = State::kUnknown;
  double share = 0;  ///< 0 to 1
  double volts = 0;
  bool charging = false;
  std::optional<double> age;  ///< s since it was told, if that is too long ago to be of now

  /// Without a state of charge it is estimated from the volts of a 12 V battery: from 11 V, at which robots
  /// switch themselves off, to 13 V. Below 11.5 V, or a fifth, it is low.
  static BatteryLevel of(double volts, std::optional<double> stateOfCharge, bool charging);
  QString text() const;
  /// What to do, in a sentence; empty while all is well.
  QString warning() const;
};

/// A battery with its level and the figures beside it. Object name "baseBattery".
class BatteryGauge final : public QWidget {
  Q_OBJECT
 public:
  explicit BatteryGauge(QWidget* parent = nullptr);
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
