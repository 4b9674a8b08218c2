// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "robotlink/base/Clock.h"

namespace robotlink::arcos {

/// The readings of a gripper's switches. A plain value.
struct GripperSensing {
  // The paddles are at their outer end, or as close together as they can be.
  bool open = false, closed = false;
  // The lift is at its upper or lower end.
  bool liftUp = false, liftDown = false;
  // Whether something presses on a paddle from inside.
  bool leftPaddle = false, rightPaddle = false;
  // Whether something is in a beam between the paddles.
  bool outerBeam = false, innerBeam = false;
};

/// The command to the gripper's motors until the next call: 1 opens or lifts, -1 closes or lowers, 0 holds.
struct GripperCommand {
  int paddles = 0, lift = 0;
  /// The paddles hold something: they keep pressing while they are not moved.
  bool grasps = false;
  bool operator==(const GripperCommand&) const = default;
};

/// The gripper of a Pioneer's microcontroller: executes the arguments of the command GRIPPER, and reports the
/// switches as ARIA's ArGripper reads them. A state machine that reads no clock. Any argument is safe.
class GripperControl {
 public:
  /// Executes the argument of a command GRIPPER; unknown ones are ignored. Returns whether a GRIPPERVAL
  /// belongs to it.
  bool obey(int action);
  /// The value of the command GRIPPERVAL, in intervals of 20 ms.
  void setValue(int intervals);
  /// Stops paddles and lift.
  void halt();
  /// Advances by the time that has passed since the last call.
  GripperCommand step(const GripperSensing& sensing, Duration passed);

  /// The byte of the information packet: bits 0 open, 1 closed, 2 paddles move, 4 lift up, 5 lift down, 6
  /// lift moves.
  std::uint8_t state() const;
  /// The byte of GRIPPERpac: bits 0 not open, 1 lift not at an end, 2 and 3 outer and inner beam are broken,
  /// 4 and 5 the left and the right paddle are not pressed, 6 the lift moves, 7 the paddles move.
  std::uint8_t switches() const;
  /// For how long the paddles press on after both are pressed, in intervals of 20 ms.
  std::uint8_t graspTime() const { return graspTime_; }

 private:
  void stepPaddles(Duration passed);
  void stepLift(Duration passed);

  GripperSensing sensing_;
  int paddles_ = 0, lift_ = 0;
  /// The lift's motion after the paddles have stopped, for storing and deploying.
  int liftNext_ = 0;
  bool grasps_ = false, carryValueNext_ = false;
  /// How long both paddles have been pressed; and how much longer the lift is raised for carrying, if it is.
  Duration pressed_{}, carrying_{};
  std::uint8_t graspTime_ = 10;
};

}  // namespace robotlink::arcos
