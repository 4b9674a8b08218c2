// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/motions/MotionNet.h"

namespace robotlink {

/// Plays the motions of a net: a request in, angles and torques of all joints out, one frame at a time.
///
/// A request takes effect where the motion that is being played allows it: at its transitions. A motion that
/// is asked for all the time is played again and again; clear() lets it run to its end, then finished() is
/// true and the last angles are kept. A pure function of the calls: no clock. One thread at a time. Angles in
/// rad, in the net's order of joints.
class MotionPlayer {
 public:
  explicit MotionPlayer(std::shared_ptr<const MotionNet> net);

  /// Takes over from somebody else: the joints are at these angles, and nothing is being played.
  void start(std::span<const double> angles);
  /// What shall be played. False if the net has no such motion; then nothing changes.
  enum class Repeat { kForever, kOnce };
  bool request(std::string_view motion, Repeat repeat = Repeat::kForever);
  /// Nothing shall be played any more.
  void clear() { requested_ = none_; }

  /// One frame on. Afterwards angles() and shares() are what the servos shall do.
  void advance(Duration frame);

  /// Whether all that was asked for has been played.
  bool finished() const { return finished_; }
  std::span<const double> angles() const { return angles_; }
  /// Share of the torque of each joint, 0 to 1; 0 for those that are let loose.
  std::span<const double> shares() const { return shares_; }
  /// Whether a key frame has said something about a joint since start(); the others are free for somebody
  /// else.
  bool moves(std::size_t joint) const { return moved_[joint]; }
  /// The motion that is being played, "" if none; and the line of its file.
  std::string motion() const;
  int line() const;

 private:
  void run();
  bool step(const MotionNet::Node& node);
  bool take(const MotionNet::Node& node, const MotionNet::Transition& transition);
  void enter(const KeyFrame& frame);
  void enter(const MotionHardness& hardness);
  void setAngles();
  void setShares();

  std::shared_ptr<const MotionNet> net_;
  int none_;  ///< the request for nothing: the entry table itself
  int requested_;
  int played_;  ///< what the entry table was last left for
  Repeat repeat_ = Repeat::kForever;
  std::size_t node_;
  bool finished_ = true;
  const KeyFrame* frame_ = nullptr;  ///< of net_; null between frames
  Duration elapsed_{};
  Duration left_{};  ///< of the time given to advance()
  std::vector<double> from_, angles_;
  const MotionHardness* hardness_ = nullptr;  ///< of net_
  Duration hardnessElapsed_{};
  std::vector<double> hardnessFrom_, hardnessNow_, shares_;
  std::vector<bool> released_, moved_;
};

}  // namespace robotlink
