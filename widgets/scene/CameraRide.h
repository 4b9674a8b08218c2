// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "widgets/scene/render/SceneCamera.h"

namespace widgets {

/// Moves a camera along with a robot: smoothly, so that the swaying of a walking robot does not move the
/// picture. The user may orbit, pan and zoom meanwhile; the camera keeps its pose relative to the place that
/// it follows. A plain state machine that is fed with the robot's pose 30 times a second. Meters and radians
/// in the field's frame.
class CameraRide {
 public:
  /// kOff: step() returns the camera unchanged.
  /// kBeside: keeps the direction of view, and looks ahead toward a ball within 2 m.
  /// kBehind: turns with the robot, looking over its shoulder.
  enum class Mode : std::uint8_t { kOff, kBeside, kBehind };
  /// The object that the camera follows.
  struct Subject {
    robotlink::Pose2 robot;
    /// Unset: unknown.
    std::optional<robotlink::Vector2> ball;
    /// Its height above the ground, m, which the camera follows; unset: it stays as high as it is.
    std::optional<double> height = {};
    /// Distance of the camera from which the robot is seen well, m.
    double distance = 2.4;
    /// Whether the subject is an arbitrary object, which is viewed as a whole, instead of a robot, which is
    /// viewed over its shoulder.
    bool isObject = false;
  };

  Mode mode() const { return mode_; }
  /// Sets the mode; a new one starts over at the next step.
  void setMode(Mode mode);
  /// Call this when another robot is followed: the next step goes there at once.
  void forget() { at_.reset(); }

  /// Returns the next camera. `far`: the camera shows the whole scene, so the first step moves it close to
  /// the robot. A jump of the robot by more than a meter is followed at once.
  SceneCamera step(const SceneCamera& camera, const Subject& subject, bool far);

 private:
  /// The place that the camera should follow.
  robotlink::Pose2 wanted(const Subject& subject) const;
  /// The camera after the first step.
  SceneCamera boarded(const SceneCamera& camera, const Subject& subject, bool far) const;

  Mode mode_ = Mode::kOff;
  /// The smoothed place that is followed; unset before the first step.
  std::optional<robotlink::Pose2> at_;
  /// The smoothed height of what is followed, if it has one.
  double height_ = 0;
};

}  // namespace widgets
