// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/config/RobotDescription.h"
#include "widgets/Gamepad.h"
#include "widgets/PackageWish.h"
#include "widgets/View.h"
#include "widgets/models/MotionCommander.h"
#include "widgets/models/TakeOver.h"

class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace robotcontrol {
class DriveState;
class MotionStatus;
}  // namespace robotcontrol

namespace widgets {

class HeadPanel;
class MotionButtons;
class SpeedPanel;
class WalkPad;

/// Steers the selected robot: takes its behaviour over, then commands walk, head and key-frame motions by
/// pad, keys and gamepad, and shows how fast it really goes. Robots on wheels are driven, and their motors
/// switched. STOP acts at the platform, whoever steers.
/// Nothing is commanded before the take-over; when pad or view lose the focus or are hidden, the robot is
/// told to stand.
class MotionView final : public View {
  Q_OBJECT
 public:
  /// Asks for the gamepad's state in each tick; tests give their own.
  using GamepadSource = std::function<Gamepad::State()>;

  explicit MotionView(ViewContext& context, QWidget* parent = nullptr);
  void setGamepad(GamepadSource source) { gamepad_ = std::move(source); }
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 protected:
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void createActions();
  void createViews();
  QWidget* createTop();
  QWidget* createBody();
  void connectSignals();

  void followRobot();
  void useRobot(const robotlink::RobotDescription* description);
  void keepLimits();
  void nameRobot();
  void switchMotors(bool on);
  void takeOver(bool take);
  void stop(bool engage);
  void play(const QString& motion);
  void stand();
  void useGamepad(const Gamepad::State& pad);
  void showStop();
  void showPad(const robotcontrol::MotionStatus* status);
  void showSpeeds(const robotcontrol::MotionStatus* status);
  const robotcontrol::DriveState* driveState() const;
  QString stateText() const;
  void send();

  MotionCommander commander_;
  TakeOver takeOver_;
  GamepadSource gamepad_;
  Gamepad::State pad_;
  WalkPad* walkPad_ = nullptr;
  QSlider* turn_ = nullptr;
  HeadPanel* head_ = nullptr;
  MotionButtons* motions_ = nullptr;
  SpeedPanel* speed_ = nullptr;
  QToolButton* take_ = nullptr;
  QToolButton* motors_ = nullptr;  // of robots on wheels
  QPushButton* stop_ = nullptr;
  QLabel* robotName_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* gamepadState_ = nullptr;
  std::string robot_;
  std::optional<robotlink::RobotDescription::Drive> drive_;  // of the robot, if it is on wheels
  MotionCommander::Limits walkLimits_;
  std::optional<MotionCommander::Limits> driveLimits_;  // as they were chosen
  PackageWish wish_;
  std::vector<const void*> tables_;
  bool askedForStatus_ = false;
};

}  // namespace widgets
