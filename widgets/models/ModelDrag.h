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

/// Moves a model of the simulation (a robot, the ball) with the mouse: where it is wanted goes out as
/// requests, at most one a tick, and what the simulation refuses is told. Poses in the field's frame, metres
/// and radians. GUI thread; answers that come after its end are harmless.
class ModelDrag {
 public:
  ModelDrag();

  /// `grabbed` is the point of the ground (or of a plane above it) that was taken hold of: it keeps its place
  /// in the model.
  void begin(const std::string& model, const robotlink::Pose2& pose, const robotlink::Vector2& grabbed);
  void moveTo(const robotlink::Vector2& cursor);
  void turn(double by);
  /// Sends where it is wanted if that changed since the last request.
  void tick(robotlink::Session& session);
  /// Sends what is left to be sent.
  void end(robotlink::Session& session);

  bool active() const { return active_; }
  const std::string& model() const { return model_; }
  const robotlink::Pose2& wanted() const { return wanted_; }
  /// Why the last place was refused; empty if it was not. Forgotten two seconds of ticks after the end.
  QString refusal() const;

 private:
  struct Answer;
  void send(robotlink::Session& session);

  bool active_ = false;
  bool unsent_ = false;
  int ticksSinceEnd_ = 0;
  std::string model_;
  robotlink::Pose2 wanted_;
  robotlink::Vector2 offset_ = robotlink::Vector2::Zero();  ///< from what was grabbed to the model's origin
  std::shared_ptr<Answer> answer_;
};

}  // namespace widgets
