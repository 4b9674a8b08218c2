// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <vector>

#include "robotcontrol/Sensing.pb.h"

class QAction;
class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSlider;

namespace widgets {

/// The settings of a camera that can be changed while it takes images, each with a slider and a number, or
/// with a box where it is on or off. Object names are "setting" and the setting's name. GUI thread.
class SettingsPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit SettingsPanel(QWidget* parent = nullptr);

  /// Shows the camera's values; null or without settings: it has none. What the user is changing, or has just
  /// changed, is not moved.
  void show(const robotcontrol::CameraSettings* settings);
  /// Sets all to what they were when the camera began.
  QAction* reset = nullptr;
  QLabel& outcome() const { return *outcome_; }

 Q_SIGNALS:
  /// The user wants a setting to have this value.
  void wanted(const QString& setting, double value);

 private:
  struct Row {
    robotcontrol::CameraSettings::Setting setting;
    /// Either the box, or the two others.
    QCheckBox* box = nullptr;
    QSlider* slider = nullptr;
    QDoubleSpinBox* number = nullptr;
    /// Since the user wanted another value.
    QElapsedTimer changed;
  };

  void rebuild(const robotcontrol::CameraSettings& settings);
  void addRow(const robotcontrol::CameraSettings::Setting& setting);
  /// Moves the controls of a row.
  static void move(Row& row, double value);
  void want(std::size_t row, double value);

  std::vector<Row> rows_;
  QWidget* form_ = nullptr;
  QLabel *none_ = nullptr, *outcome_ = nullptr;
};

}  // namespace widgets
