// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "widgets/steering/SteeringState.h"

class QAction;
class QLabel;
class QToolButton;

namespace robotlink {
class CommandTable;
class Session;
}  // namespace robotlink

namespace widgets {

/// Says who steers a robot that several people can steer, with a button that takes the steering over or gives
/// it up. Hidden while nobody does. GUI thread; the commands must outlive it.
class SteeringBar final : public QWidget {
  Q_OBJECT
 public:
  SteeringBar(const robotlink::CommandTable& commands, QWidget* parent);
  /// Shows who steers the robot now; call this in each tick.
  void refresh(robotlink::Session& session, const std::string& robot);

 private:
  void run();

  const robotlink::CommandTable& commands_;
  QLabel* text_;
  QAction* take_;
  QToolButton* button_;
  std::optional<SteeringState> state_;
  std::string robot_;
};

}  // namespace widgets
