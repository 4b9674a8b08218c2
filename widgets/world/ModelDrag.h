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

/// Moves a model of the simulation (a robot, the ball) with the mouse. The poses go out as requests, at most
/// one per tick, and the simulation's refusals are kept for display. Poses are in the field's frame, meters
/// and radians. GUI thread. Replies that arrive after its destruction are ignored.
class ModelDrag {
 public:
  ModelDrag();

  /// The button was pressed. `grabbed` is the point of the ground (or of a plane above it) under the cursor;
  /// the cursor stays at this point of the model during the drag.
  void begin(const std::string& model, const robotlink::Pose2& pose, const robotlink::Vector2& grabbed);
  /// The mouse was dragged to a point in the same plane.
  /// `step`: what x and y are multiples of, m; 0: anything.
  void moveTo(const robotlink::Vector2& cursor, double step = 0);
  /// Turns the model by an angle, counterclockwise.
  void turn(double by);
  /// Requests the pose if it changed since the last request. Called 30 times a second.
  void tick(robotlink::Session& session);
  /// The button was released: requests the last pose if that has not been done.
  void end(robotlink::Session& session);

  /// Ends the drag without a request.
  void cancel();

  /// Whether the button is pressed.
  bool active() const { return active_; }
  const std::string& model() const { return model_; }
  /// The pose to which the model is dragged.
  const robotlink::Pose2& wanted() const { return wanted_; }
  /// The reason why the newest pose was refused; empty if it was not. Cleared two seconds after the end.
  QString refusal() const;

 private:
  /// The reply to the newest request, shared with its callback.
  struct Answer;
  void send(robotlink::Session& session);

  bool active_ = false;
  /// Whether `wanted_` has not been requested yet.
  bool unsent_ = false;
  int ticksSinceEnd_ = 0;
  std::string model_;
  robotlink::Pose2 wanted_;
  /// From the grabbed point to the model's origin.
  robotlink::Vector2 offset_ = robotlink::Vector2::Zero();
  std::shared_ptr<Answer> answer_;
};

}  // namespace widgets
