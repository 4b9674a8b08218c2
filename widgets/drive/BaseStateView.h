// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "widgets/PackageWish.h"
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

/// How a robot on wheels and the line to it do: battery, motors, stall, bumpers, odometry, speeds, packets.
/// Motors and sonars are switched here, the odometry is set to 0; all of it at the base, not through its
/// program.
class BaseStateView final : public View {
  Q_OBJECT
 public:
  explicit BaseStateView(ViewContext& context, QWidget* parent = nullptr);

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createRows();
  void createViews();
  QWidget* createToolRow();
  void connectSignals();
  void send(const robotcontrol::ControlDrive& control);

  void connectNow();
  /// Greys out what the base said too long ago, and says how long.
  void showAge(std::optional<double> age);
  static QString timesText(std::uint64_t count);
  void showBase(const robotcontrol::DriveState* state, std::optional<double> staleAge);
  void showMotion(const robotcontrol::DriveState* state);
  void showLink(const robotcontrol::LinkStatus* status, double age);
  void showStop(const robotcontrol::DriveState* state);

  std::string robot_;
  PackageWish wish_;
  RobotChoice* robots_ = nullptr;
  QAction *motors_ = nullptr, *sonar_ = nullptr, *resetOdometry_ = nullptr;
  BatteryGauge* battery_ = nullptr;
  StateRows *base_ = nullptr, *motion_ = nullptr, *link_ = nullptr;
  QLabel* problem_ = nullptr;
  QPushButton* connectNow_ = nullptr;
  QWidget* body_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
