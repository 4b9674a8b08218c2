// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "widgets/scene/SceneCamera.h"

namespace widgets {

/// Takes a camera along with a robot, gently: what a walking robot sways the picture does not. How the camera
/// stands to the robot is up to whoever turns and moves it meanwhile. A plain state machine, told the robot's
/// place 30 times a second.
class CameraRide {
 public:
  /// Beside: the camera keeps its direction, and leads towards a ball that is near. Behind: it turns with the
  /// robot.
  enum class Mode : std::uint8_t { kOff, kBeside, kBehind };
  struct Subject {
    robotlink::Pose2 robot;
    std::optional<robotlink::Vector2> ball;
    double distance = 2.4;  ///< m, from which it is seen well
  };

  Mode mode() const { return mode_; }
  /// From the next step on.
  void setMode(Mode mode);
  /// The robot is another one now: goes there at once.
  void forget() { at_.reset(); }

  /// Where the camera is next. `far`: it shows everything, so that at first it comes near.
  SceneCamera step(const SceneCamera& camera, const Subject& subject, bool far);

 private:
  robotlink::Pose2 wanted(const Subject& subject) const;
  SceneCamera boarded(const SceneCamera& camera, const Subject& subject, bool far) const;

  Mode mode_ = Mode::kOff;
  std::optional<robotlink::Pose2> at_;  // what it follows, without the swaying; none: it begins
};

}  // namespace widgets
