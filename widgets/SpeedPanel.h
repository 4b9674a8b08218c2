// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <array>
#include <optional>

#include "widgets/models/MeasuredSpeed.h"
#include "widgets/models/MotionCommander.h"

class QDoubleSpinBox;
class QLabel;

namespace widgets {

/// What is asked of the robot, how it truly moves and what it believes, side by side, in mm/s and rad/s; and
/// the limits that full deflection means.
class SpeedPanel final : public QGroupBox {
  Q_OBJECT
 public:
  explicit SpeedPanel(QWidget* parent = nullptr);
  void showSpeeds(const Speed& asked, const std::optional<Speed>& measured,
                  const std::optional<Speed>& believed);
  MotionCommander::Limits limits() const;
  void setLimits(const MotionCommander::Limits& limits);
  /// What the limits may be at most. Robots on wheels do not go sideways: that column is hidden.
  void setRobot(bool wheels, const MotionCommander::Limits& greatest);

 Q_SIGNALS:
  void limitsChanged();

 private:
  enum Row { kAsked, kMeasured, kBelieved, kRows };
  void createTable();
  void createLimits();
  void showRow(Row row, const std::optional<Speed>& speed);

  std::array<std::array<QLabel*, 3>, kRows> cells_{};
  QLabel* sideways_ = nullptr;          // the head of its column
  QDoubleSpinBox* speed_ = nullptr;     // mm/s
  QDoubleSpinBox* rotation_ = nullptr;  // rad/s
};

}  // namespace widgets
