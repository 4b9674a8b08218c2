// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "widgets/PackageSubscription.h"
#include "widgets/View.h"

class QAction;
class QLabel;
class QPushButton;

namespace robotcontrol {
class ControlDrive;
class DriveState;
class LinkStatus;
}  // namespace robotcontrol

namespace widgets {

class BatteryGauge;
class EmptyHint;
class RobotChoice;
class StateRows;

/// The state of a robot on wheels and of the line to it: battery, motors, stall, bumpers, odometry, speeds,
/// packets. Motors and sonars are switched and the odometry is reset by requests to the base (ControlDrive),
/// not through the robot's program. The buttons show what the base reports, not what was clicked.
///
/// Registered as "base-state". GUI thread.
class BaseStateView final : public View {
  Q_OBJECT
 public:
  explicit BaseStateView(ViewContext& context, QWidget* parent = nullptr);

  /// Shows the newest DriveState, DriveRequest and LinkStatus at the shown instant.
  void tick() override;

 private:
  /// Motors, sonars, reset of the odometry.
  void createActions();
  /// The rows of the groups base, motion and line.
  void createRows();
  void createViews();
  /// Choice of the robot, and the buttons of the actions.
  QWidget* createToolRow();
  void connectSignals();
  /// Sends a request to the base; a refusal is shown.
  void send(const robotcontrol::ControlDrive& control);

  /// Runs the command robot.connect-now.
  void connectNow();
  /// Grays values that the base has not updated for too long; `age` in s, unset: they are up to date.
  void showAge(std::optional<double> age);
  static QString timesText(std::uint64_t count);
  void showBase(const robotcontrol::DriveState* state, std::optional<double> staleAge);
  /// Odometry and speeds. `state` may be null.
  void showMotion(const robotcontrol::DriveState* state);
  /// The line. `status` may be null; `age` in s.
  void showLink(const robotcontrol::LinkStatus* status, double age);
  /// The emergency stops of the robot and of the workbench. `state` may be null.
  void showStop(const robotcontrol::DriveState* state);

  /// The robot that is shown; empty: none.
  std::string robot_;
  /// Requests that the packages shown here are published.
  PackageSubscription subscription_;
  RobotChoice* robots_ = nullptr;
  QAction *motors_ = nullptr, *sonar_ = nullptr, *resetOdometry_ = nullptr;
  /// A row of base_.
  BatteryGauge* battery_ = nullptr;
  /// The groups of rows.
  StateRows *base_ = nullptr, *motion_ = nullptr, *link_ = nullptr;
  /// The reason of the last refusal; hidden without one.
  QLabel* problem_ = nullptr;
  /// Visible while the line is lost.
  QPushButton* connectNow_ = nullptr;
  /// All rows; hidden for robots without wheels.
  QWidget* body_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
