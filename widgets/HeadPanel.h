// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <array>

#include "widgets/models/MotionCommander.h"

class QComboBox;
class QLabel;
class QSlider;

namespace robotlink {
struct RobotDescription;
}

namespace widgets {

/// What the head shall do: a list of modes, and sliders for its joints in degrees. Moving a slider chooses
/// the mode "angles". Ranges are those of the robot's description. Who steers asks for wish() as often as he
/// commands.
class HeadPanel final : public QGroupBox {
  Q_OBJECT
 public:
  explicit HeadPanel(QWidget* parent = nullptr);
  void setRobot(const robotlink::RobotDescription* robot);
  HeadWish wish() const;
  void setWish(const HeadWish& wish);

 private:
  enum Joint { kTilt, kPan, kRoll, kMouth, kJoints };
  void createSlider(Joint joint, const char* name, const QString& text);
  void showValue(Joint joint);

  QComboBox* mode_;
  std::array<QSlider*, kJoints> sliders_{};  // tenths of a degree
  std::array<QLabel*, kJoints> values_{};
};

}  // namespace widgets
