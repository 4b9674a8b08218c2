// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <string>

#include "robotlink/base/Geometry.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// Sends a robot on wheels to a place chosen with the mouse: press at the goal, drag toward the direction in
/// which the robot should look on arrival, release. The class keeps the state of this gesture and sends the
/// request; it paints nothing. Poses are in the field's frame, meters and radians. GUI thread. Replies that
/// arrive after its destruction are ignored.
class GoalSender {
 public:
  /// A goal, while it is being chosen and after it was sent.
  struct Aim {
    robotlink::Pose2 pose;
    /// True until the drag has chosen a heading.
    bool anyHeading = true;
    /// Name of the place on the map that was pressed; empty: a free place.
    std::string name;
  };

  GoalSender();

  /// The button was pressed.
  void begin(Aim at);
  /// The mouse was dragged. A cursor farther than `turnRadius` (m) from the goal chooses the heading toward
  /// the cursor; a nearer one resets it.
  void moveTo(const robotlink::Vector2& cursor, double turnRadius);
  /// The button was released: requests the goal.
  void end(robotlink::Session& session, const std::string& robot);
  /// Ends the gesture without sending.
  void abandon() { aim_.reset(); }
  /// Requests that the robot cancels its goal.
  void cancelGoal(robotlink::Session& session, const std::string& robot);
  /// Called 30 times a second; counts the time until notices disappear.
  void tick();

  /// The goal that is being chosen; unset outside of a gesture.
  const std::optional<Aim>& aim() const { return aim_; }
  /// The goal that was sent, until the program publishes a path, or for three seconds; shown meanwhile.
  const std::optional<Aim>& sent() const { return sent_; }
  /// The program has published a path.
  void settled() { sent_.reset(); }
  /// Returns why the last goal was refused; empty if it was not. Cleared after four seconds.
  QString refusal() const;

 private:
  /// The reply to the last request, shared with its callback.
  struct Answer {
    QString refusal;
    /// Ticks since the reply arrived.
    int ticks = 0;
  };
  void send(robotlink::Session& session, const std::string& robot, const Aim& aim, bool canceled);

  /// The aim at the time of the press.
  std::optional<Aim> start_;
  std::optional<Aim> aim_, sent_;
  /// Ticks since the goal was sent.
  int sentTicks_ = 0;
  std::shared_ptr<Answer> answer_;
};

}  // namespace widgets
