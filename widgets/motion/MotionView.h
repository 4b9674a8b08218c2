// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/config/RobotDescription.h"
#include "widgets/PackageSubscription.h"
#include "widgets/View.h"
#include "widgets/motion/Gamepad.h"
#include "widgets/motion/ManualControl.h"
#include "widgets/motion/MotionCommander.h"

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
class SteeringBar;
class WalkPad;

/// Manual control of the selected robot. "Take over" switches its behavior (or driving) task to the solution
/// "obey"; from then on the view sends motion requests from the pad, the keyboard, the sliders and the
/// gamepad, ten times a second and whenever they change. Robots on wheels are driven, and their motors can be
/// switched. STOP is a request to the platform and works whatever the program does. The view also shows
/// commanded, true and estimated speed.
///
/// Nothing is commanded before manual control is confirmed, and nothing while somebody else steers the robot
/// over a link. When the view is hidden, the window loses the
/// focus, or another robot is selected, the robot is commanded to stand still.
///
/// Registered as "motion". GUI thread.
class MotionView final : public View {
  Q_OBJECT
 public:
  /// Returns the gamepad's state; called once in each tick. Tests replace it.
  using GamepadSource = std::function<Gamepad::State()>;

  explicit MotionView(ViewContext& context, QWidget* parent = nullptr);
  void setGamepad(GamepadSource source) { gamepad_ = std::move(source); }
  /// Reads pad, sliders and gamepad, and sends a motion request if one is due.
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 protected:
  /// Commands the robot to stand still.
  void hideEvent(QHideEvent* event) override;
  /// Commands the robot to stand still when the window is deactivated.
  void changeEvent(QEvent* event) override;

 private:
  void createActions();
  void createViews();
  /// Row with the robot's name, "Take over", the state and STOP.
  QWidget* createTop();
  /// Pad and turn slider on the left; speeds, motors, head and motions on the right.
  QWidget* createBody();
  void connectSignals();

  /// Adopts the selected robot and its solution tables, and updates who has control.
  void followRobot();
  /// Shows the controls that fit the robot (legs or wheels) and restores its limits. May be null.
  void useRobot(const robotlink::RobotDescription* description);
  /// Remembers the limits in the panel for the robot's kind.
  void keepLimits();
  /// Writes the robot's name into the title and into STOP's tool tip.
  void nameRobot();
  /// Requests the motors of the base on or off; the button follows what the base reports.
  void switchMotors(bool on);
  /// Requests or returns manual control.
  void takeOver(bool take);
  /// Engages or releases the emergency stop at the platform.
  void stop(bool engage);
  /// Commands a key-frame motion; ignored without manual control and for wheels.
  void play(const QString& motion);
  /// Resets all inputs and, with manual control, commands the robot to stand still.
  void stand();
  /// Applies the gamepad's state; buttons act when they are pressed, not while they are held.
  void useGamepad(const Gamepad::State& pad);
  /// Updates STOP from the SimulationStatus.
  void showStop();
  /// Updates all controls but STOP. `status` may be null: the robot has not reported any.
  void showPad(const robotcontrol::MotionStatus* status);
  /// Updates the speed panel and the pad's measured vector. `status` may be null.
  void showSpeeds(const robotcontrol::MotionStatus* status);
  /// Newest DriveState of the robot; null if there is none.
  const robotcontrol::DriveState* driveState() const;
  /// One sentence: who has control, or what prevents it.
  QString stateText() const;
  /// Sends the commander's command with the timeline's newest time.
  void send();

  /// Turns the inputs into commands and decides when one is due.
  MotionCommander commander_;
  /// Whether the user or the program controls the robot.
  ManualControl manualControl_;
  GamepadSource gamepad_;
  /// The gamepad's state in the last tick, to detect pressed buttons.
  Gamepad::State pad_;
  WalkPad* walkPad_ = nullptr;
  QSlider* turn_ = nullptr;
  HeadPanel* head_ = nullptr;
  MotionButtons* motions_ = nullptr;
  SpeedPanel* speed_ = nullptr;
  QToolButton* take_ = nullptr;
  /// Visible for robots on wheels only.
  QToolButton* motors_ = nullptr;
  QPushButton* stop_ = nullptr;
  QLabel* robotName_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* gamepadState_ = nullptr;
  /// Who steers, of those who can over a link.
  SteeringBar* steering_ = nullptr;
  std::string robot_;
  /// What is known of the robot; null: nothing.
  std::shared_ptr<const robotlink::RobotDescription> description_;
  /// The robot's drive; unset if it has legs or no description.
  std::optional<robotlink::RobotDescription::Drive> drive_;
  /// The limits that the user set for walking robots.
  MotionCommander::Limits walkLimits_;
  /// The limits that the user set for robots on wheels; unset: half of the drive's maximum.
  std::optional<MotionCommander::Limits> driveLimits_;
  /// Requests that DriveState is published.
  PackageSubscription subscription_;
  /// Addresses of the solution tables that manualControl_ has seen.
  std::vector<const void*> tables_;
  /// Whether the debug key of MotionStatus was requested for this robot.
  bool askedForStatus_ = false;
};

}  // namespace widgets
