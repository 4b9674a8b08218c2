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

/// Sends a robot to a place with the mouse: press where it shall go, drag to where it shall look then,
/// release. Poses in the field's frame, metres and radians. GUI thread; answers that come after its end are
/// harmless.
class GoalSender {
 public:
  /// What is aimed at between press and release.
  struct Aim {
    robotlink::Pose2 pose;
    bool anyHeading = true;
    std::string name;  ///< of the place, if it has one
  };

  GoalSender();

  void begin(Aim at);
  /// A cursor that is farther than `turnRadius` metres from the goal says its heading.
  void moveTo(const robotlink::Vector2& cursor, double turnRadius);
  /// Sends it.
  void end(robotlink::Session& session, const std::string& robot);
  /// Forgets it without sending.
  void abandon() { aim_.reset(); }
  /// The robot shall go nowhere.
  void cancelGoal(robotlink::Session& session, const std::string& robot);
  /// Called in each tick.
  void tick();

  const std::optional<Aim>& aim() const { return aim_; }
  /// What was sent last until the program answers with a path, or three seconds have passed; for the eye.
  const std::optional<Aim>& sent() const { return sent_; }
  void settled() { sent_.reset(); }
  /// Why the last goal was refused; empty if it was not. Forgotten after some seconds of ticks.
  QString refusal() const;

 private:
  struct Answer {
    QString refusal;
    int ticks = 0;  ///< since it came
  };
  void send(robotlink::Session& session, const std::string& robot, const Aim& aim, bool cancelled);

  std::optional<Aim> start_;  ///< as it was pressed
  std::optional<Aim> aim_, sent_;
  int sentTicks_ = 0;
  std::shared_ptr<Answer> answer_;
};

}  // namespace widgets
