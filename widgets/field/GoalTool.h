// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "widgets/models/DriveAims.h"
#include "widgets/models/GoalSender.h"

class QAction;

namespace robotlink {
class Session;
}

namespace widgets {

class FieldCanvas;

/// Sends robots on wheels to places that are clicked in a canvas, shows where all of them go, and calls them
/// back. GUI thread.
class GoalTool final : public QObject {
  Q_OBJECT
 public:
  /// `owner` is the view, whose actions these are; both must outlive it.
  GoalTool(QWidget& owner, FieldCanvas& canvas, robotlink::Session& session);

  QAction* send() const { return send_; }
  QAction* cancel() const { return cancel_; }
  /// Once a tick: which robot is sent by a click (empty: none can be), and where all of them go.
  void tick(const std::string& robot, std::vector<DriveAim> aims);
  /// Why the last goal was refused; empty if it was not.
  QString refusal() const;

 private:
  void connectCanvas();
  void show();
  void cancelGoal();
  bool going() const;

  FieldCanvas& canvas_;
  robotlink::Session& session_;
  QAction *send_ = nullptr, *cancel_ = nullptr;
  GoalSender sender_;
  std::string robot_;
  std::vector<DriveAim> aims_;
};

}  // namespace widgets
