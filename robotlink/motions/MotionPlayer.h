// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/motions/MotionNet.h"

namespace robotlink {

/// Plays the motions of a net: a request goes in, and angles and torques of all joints come out, one frame at
/// a time.
///
/// A request takes effect where the motion being played allows it: at its transitions. A requested motion is
/// repeated until clear() is called or another one is requested, or is played once (Repeat::kOnce). When the
/// last motion has ended, finished() is true and the last angles are kept. The state depends only on the
/// calls: there is no clock. One thread at a time. Angles in rad, in the net's order of joints.
class MotionPlayer {
 public:
  explicit MotionPlayer(std::shared_ptr<const MotionNet> net);

  /// Begins at these joint angles, with nothing requested; call it after another source has moved the joints.
  void start(std::span<const double> angles);
  /// kOnce plays the motion a single time and then finishes.
  enum class Repeat { kForever, kOnce };
  /// Requests a motion. Returns false, changing nothing, if the net has no motion of that name.
  bool request(std::string_view motion, Repeat repeat = Repeat::kForever);
  /// Withdraws the request: the current motion plays to its end.
  void clear() { requested_ = none_; }

  /// Advances by one frame. Afterwards angles() and shares() are the commands for the servos.
  void advance(Duration frame);

  /// Whether everything that was requested has been played.
  bool finished() const { return finished_; }
  std::span<const double> angles() const { return angles_; }
  /// The share of each joint's torque, 0 to 1; 0 for released joints.
  std::span<const double> shares() const { return shares_; }
  /// Whether a key frame has set or released this joint since start(); other joints may be moved by something
  /// else.
  bool moves(std::size_t joint) const { return moved_[joint]; }
  /// The motion being played, "" if there is none.
  std::string motion() const;
  /// How the motion being played moves the robot; nothing if there is none.
  MotionNet::Displacement displacement() const;

 private:
  void run();
  bool step(const MotionNet::Node& node);
  bool take(const MotionNet::Node& node, const MotionNet::Transition& transition);
  void enter(const KeyFrame& frame);
  void enter(const MotionHardness& hardness);
  void setAngles();
  void setShares();

  std::shared_ptr<const MotionNet> net_;
  /// The index of the entry table, which as a request means "nothing".
  int none_;
  int requested_;
  /// The request for which the entry table was last left.
  int played_;
  Repeat repeat_ = Repeat::kForever;
  std::size_t node_;
  bool finished_ = true;
  /// The key frame being played, in net_; null between frames.
  const KeyFrame* frame_ = nullptr;
  Duration elapsed_{};
  /// The part of advance()'s time that is not yet used.
  Duration left_{};
  /// Angles at the start of the key frame, and now.
  std::vector<double> from_, angles_;
  /// The last hardness line, in net_; null before the first.
  const MotionHardness* hardness_ = nullptr;
  Duration hardnessElapsed_{};
  /// Torque shares at the start of the hardness line, now, and now with released joints at 0.
  std::vector<double> hardnessFrom_, hardnessNow_, shares_;
  std::vector<bool> released_, moved_;
};

}  // namespace robotlink
