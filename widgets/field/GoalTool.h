// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "widgets/field/GoalSender.h"
#include "widgets/world/DriveAims.h"

class QAction;

namespace robotlink {
class Session;
}

namespace widgets {

class FieldCanvas;

/// Sends a robot on wheels to a goal that is chosen in a FieldCanvas, shows the paths of all robots there,
/// and cancels goals. GUI thread; a child of the view.
class GoalTool final : public QObject {
  Q_OBJECT
 public:
  /// `owner` is the view, which gets the actions; it, the canvas and the session must outlive the tool.
  GoalTool(QWidget& owner, FieldCanvas& canvas, robotlink::Session& session);

  /// While it is checked a click in the canvas chooses a goal; otherwise Control and click does.
  QAction* send() const { return send_; }
  /// Ends the choice of a goal, else cancels the robot's goal.
  QAction* cancel() const { return cancel_; }
  /// Called once per tick. `robot` is the robot that a click sends (empty: none can be sent), `aims` the
  /// goals of all robots.
  void tick(const std::string& robot, std::vector<DriveAim> aims);
  /// Returns why the last goal was refused; empty if it was not.
  QString refusal() const;

 private:
  void connectCanvas();
  /// Updates actions and canvas.
  void show();
  void cancelGoal();
  /// Whether the robot has a goal.
  bool going() const;

  FieldCanvas& canvas_;
  robotlink::Session& session_;
  QAction *send_ = nullptr, *cancel_ = nullptr;
  GoalSender sender_;
  std::string robot_;
  std::vector<DriveAim> aims_;
};

}  // namespace widgets
