// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <array>

#include "widgets/motion/MotionCommander.h"

class QComboBox;
class QLabel;
class QSlider;

namespace robotlink {
struct RobotDescription;
}

namespace widgets {

/// Controls for the robot's head: a list of modes and one slider per joint. Moving a slider selects the mode
/// "angles". The sliders' ranges are the joint limits in the robot's description; joints that it does not
/// have are disabled. The panel sends nothing: MotionView reads wish() in every tick. GUI thread.
class HeadPanel final : public QGroupBox {
  Q_OBJECT
 public:
  explicit HeadPanel(QWidget* parent = nullptr);
  /// Sets the ranges of the sliders. Null: no robot is known; all sliders are enabled from -90 to 90 degrees.
  void setRobot(const robotlink::RobotDescription* robot);
  /// The selected mode and the joint angles in rad.
  HeadTarget target() const;
  /// Selects the mode and moves the sliders to the angles.
  void setTarget(const HeadTarget& target);

 private:
  /// The joints in the order of their sliders.
  enum Joint { kTilt, kPan, kRoll, kMouth, kJoints };
  /// Adds a row with a slider and its value. `name` is the object name, `text` the label.
  void createSlider(Joint joint, const char* name, const QString& text);
  /// Writes the slider's angle in degrees next to it.
  void showValue(Joint joint);

  QComboBox* mode_;
  /// Values are tenths of a degree.
  std::array<QSlider*, kJoints> sliders_{};
  std::array<QLabel*, kJoints> values_{};
};

}  // namespace widgets
