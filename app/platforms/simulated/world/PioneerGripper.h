// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotlink/arcos/server/GripperControl.h"

namespace simcore {
class Simulation;
}

namespace app {

/// The gripper of a simulated Pioneer: where its motors and sensors are in the simulation. The model's
/// prismatic joints `paddleLeft`, `paddleRight` (0 where they meet, their upper limit where they are open)
/// and `lift` have position servos; contact sensors `paddleLeftTouch`, `paddleRightTouch` feel what is
/// grasped; the distance sensors `innerBeam`, `outerBeam` of the left paddle look at the right one. A plain
/// value.
class PioneerGripper {
 public:
  /// Unset if the robot has no complete gripper.
  static std::optional<PioneerGripper> of(const simcore::Simulation& simulation, const std::string& robot);

  robotlink::arcos::GripperSensing sense(const simcore::Simulation& simulation) const;
  /// Has the servos move paddles and lift; one that holds stays where it is, or keeps pressing.
  void move(simcore::Simulation& simulation, const robotlink::arcos::GripperCommand& command) const;

 private:
  /// Indices of the servo and of the sensor of its position.
  struct Slide {
    std::size_t servo = 0, position = 0;
  };
  static bool find(const simcore::Simulation& simulation, const std::string& path, Slide& slide);
  void move(simcore::Simulation& simulation, const Slide& slide, int direction, double preload) const;

  Slide left_, right_, lift_;
  std::size_t leftTouch_ = 0, rightTouch_ = 0, innerBeam_ = 0, outerBeam_ = 0;
};

}  // namespace app
