// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/config/RobotDescription.h"
#include "widgets/PackageSubscription.h"
#include "widgets/View.h"
#include "widgets/motion/Gamepad.h"
#include "widgets/motion/ManualSteering.h"

class QBoxLayout;
class QLabel;
class QLayout;
class QPushButton;
class QScrollArea;
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

/// Manual control of the selected robot by the pad, the keyboard, the sliders and the gamepad, see
/// ManualSteering. Robots on wheels are driven, and their motors can be switched. STOP is a request to the
/// platform and works whatever the program does. The view also shows commanded, true and estimated speed.
///
/// When the view is hidden or the window loses the focus, a robot that is steered by the view is commanded to
/// stand still.
///
/// Registered as "motion". GUI thread.
class MotionView final : public View {
  Q_OBJECT
 public:
  /// Returns the gamepad's state; called once in each tick. Tests replace it.
  using GamepadSource = std::function<Gamepad::State()>;

  explicit MotionView(ViewContext& context, QWidget* parent = nullptr);
  void setGamepad(GamepadSource source) { gamepad_ = std::move(source); }
  /// Reads pad, sliders and gamepad, and shows what is commanded.
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  /// Commands the robot to stand still.
  void hideEvent(QHideEvent* event) override;
  /// Commands the robot to stand still when the window is deactivated.
  void changeEvent(QEvent* event) override;

 private:
  void createActions();
  void createViews();
  /// Row with the robot's name, "Take over", the state and STOP.
  QWidget* createTop();
  /// Pad and turn slider on the left; speeds, motors, head and motions on the right, or below where it is
  /// too narrow for both.
  QWidget* createBody();
  QLayout* createPadColumn(QWidget* body);
  QLayout* createPanelColumn(QWidget* body);
  /// Puts both columns side by side, or one below the other.
  void arrange();
  void connectSignals();

  /// Adopts the selected robot.
  void followRobot();
  /// Shows the controls that fit the robot (legs or wheels) and restores its limits. May be null.
  void useRobot(const robotlink::RobotDescription* description);
  /// Remembers the limits in the panel for the robot's kind.
  void keepLimits();
  /// Writes the robot's name into the title and into STOP's tooltip.
  void nameRobot();
  /// Requests the motors of the base on or off; the button follows what the base reports.
  void switchMotors(bool on);
  /// Requests or returns manual control.
  void takeOver(bool take);
  /// Engages or releases the emergency stop at the platform.
  void stop(bool engage);
  /// Commands a key-frame motion; ignored without manual control and for wheels.
  void play(const QString& motion);
  /// Releases all inputs.
  void stand();
  /// Passes the head's sliders on, and shows what a command has set.
  void steerHead();
  /// Applies the gamepad's state; buttons act when they are pressed, not while they are held.
  void useGamepad(const Gamepad::State& pad);
  /// Runs the command of a button.
  void runCommand(const std::string& command);
  /// Lets the user choose what the gamepad does.
  void bindGamepad();
  /// Updates STOP from the SimulationStatus.
  void showStop();
  /// Updates all controls but STOP. `status` may be null: the robot has not reported any.
  void showPad(const robotcontrol::MotionStatus* status);
  /// Updates the speed panel and the pad's measured vector. `status` may be null.
  void showSpeeds(const robotcontrol::MotionStatus* status);
  /// Newest DriveState of the robot; null if there is none.
  const robotcontrol::DriveState* driveState() const;
  /// A sentence: who has control, or what prevents it.
  QString stateText() const;

  ManualSteering& manual_;
  GamepadSource gamepad_;
  /// The gamepad's state in the last tick, to detect pressed buttons.
  Gamepad::State pad_;
  /// The reason why the last command of a button failed; empty: it did not.
  QString padFailure_;
  QScrollArea* area_ = nullptr;
  QBoxLayout* columns_ = nullptr;
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
  /// Shows which of the people on the link steers.
  SteeringBar* steering_ = nullptr;
  std::string robot_;
  /// The description of the robot; null: unknown.
  std::shared_ptr<const robotlink::RobotDescription> description_;
  /// The robot's drive; unset if it has legs or no description.
  std::optional<robotlink::RobotDescription::Drive> drive_;
  /// The limits that the user set for walking robots.
  MotionCommander::Limits walkLimits_;
  /// The limits that the user set for robots on wheels; unset: half of the drive's maximum.
  std::optional<MotionCommander::Limits> driveLimits_;
  /// Requests that DriveState is published.
  PackageSubscription subscription_;
  /// The heads that the panel and the steering had when they agreed last.
  HeadTarget panelHead_, commandedHead_;
  /// Whether the keys are for the pad as soon as manual control is confirmed.
  bool isPadNext_ = false;
};

}  // namespace widgets
