// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <array>
#include <optional>

#include "widgets/motion/MeasuredSpeed.h"
#include "widgets/motion/MotionCommander.h"

class QDoubleSpinBox;
class QLabel;

namespace widgets {

/// Three speeds side by side, the commanded, the true and the estimated one, in mm/s and rad/s; below them
/// the limits at full deflection of the sticks. Values are in the robot's frame. The interface
/// uses m/s and rad/s. GUI thread.
class SpeedPanel final : public QGroupBox {
  Q_OBJECT
 public:
  explicit SpeedPanel(QWidget* parent = nullptr);
  /// `measured` is the true speed by the simulator, `believed` what the robot reports; empty: shown as a
  /// dash.
  void showSpeeds(const Speed& asked, const std::optional<Speed>& measured,
                  const std::optional<Speed>& believed);
  /// The limits in the fields.
  MotionCommander::Limits limits() const;
  /// Sets both fields, clamped to their ranges, and so may emit limitsChanged().
  void setLimits(const MotionCommander::Limits& limits);
  /// `greatest`: upper bounds of the limits. Robots on wheels cannot move sideways, so that column is hidden
  /// for them.
  void setRobot(bool wheels, const MotionCommander::Limits& greatest);

 Q_SIGNALS:
  /// The user or setLimits() changed a limit.
  void limitsChanged();

 private:
  /// The rows of the table.
  enum Row { kAsked, kMeasured, kBelieved, kRows };
  /// Creates the table of the speeds.
  void createTable();
  /// Creates the two fields below it.
  void createLimits();
  void showRow(Row row, const std::optional<Speed>& speed);

  /// The cells by Row; columns are x (forward), y (left) and rotation.
  std::array<std::array<QLabel*, 3>, kRows> cells_{};
  /// Header of the column y.
  QLabel* sideways_ = nullptr;
  QDoubleSpinBox* speed_ = nullptr;     ///< mm/s
  QDoubleSpinBox* rotation_ = nullptr;  ///< rad/s
};

}  // namespace widgets
