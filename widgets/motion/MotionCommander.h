// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "widgets/motion/MeasuredSpeed.h"

namespace robotcontrol {
class MotionStatus;
class RemoteMotion;
}  // namespace robotcontrol

namespace widgets {

/// Deflection of the sticks, each axis from -1 to 1: forward, to the left, counterclockwise.
struct WalkAxes {
  double forward = 0;
  double left = 0;
  double turn = 0;
  bool operator==(const WalkAxes&) const = default;
  /// Whether nothing is deflected.
  bool zero() const { return forward == 0 && left == 0 && turn == 0; }
};

/// The command for the head. The kinds are in the order of robotcontrol.HeadMode; the angles (rad)
/// are used by kAngles only.
struct HeadTarget {
  /// Look ahead, search for the ball, follow the ball with the camera, look around, or hold the angles.
  enum class Kind : std::uint8_t { kLookAhead, kSearchBall, kTrackBall, kLookAround, kAngles };
  Kind kind = Kind::kLookAhead;
  double tilt = 0;
  double pan = 0;
  double roll = 0;
  double mouth = 0;
  bool operator==(const HeadTarget&) const = default;
};

/// A joint of the head: its name in commands, its name in robots' descriptions, and its angle.
struct HeadJoint {
  const char* name;
  const char* joint;
  double HeadTarget::*angle;
};
inline constexpr std::array<HeadJoint, 4> kHeadJoints{{{"tilt", "neckTilt", &HeadTarget::tilt},
                                                       {"pan", "headPan", &HeadTarget::pan},
                                                       {"roll", "headRoll", &HeadTarget::roll},
                                                       {"mouth", "mouth", &HeadTarget::mouth}}};

/// Turns the inputs of pad, keys, sliders and gamepad into motion commands, and decides when one is due: at
/// once when something changed, and ten times a second (every third tick) while it is active, so that a robot
/// can stop when commands no longer arrive. A key-frame motion is commanded until the robot reports that it
/// plays it, but for at most a second, so that it is played once. No I/O, no clock; not thread-safe.
class MotionCommander {
 public:
  /// The speeds at full deflection.
  struct Limits {
    /// m/s, in any direction of walking.
    double speed = 0.15;
    double rotation = 1.0;  ///< rad/s
    bool operator==(const Limits&) const = default;
  };
  /// The name under which play() requests getting up.
  static constexpr char kGetUp[] = "get-up";

  void setLimits(Limits limits) { limits_ = limits; }
  const Limits& limits() const { return limits_; }
  /// Replaces a velocity that was commanded by walk().
  void setAxes(const WalkAxes& axes);
  const WalkAxes& axes() const { return axes_; }
  void setHead(const HeadTarget& head);
  const HeadTarget& head() const { return head_; }
  /// Commands a velocity, whatever the limits are, until the axes are set or halt() is called.
  void walk(const Speed& velocity);
  /// Commands the angle of a joint in rad, by its name in the robot's description. From then on the robot
  /// holds all other joints where they are, until it is commanded to walk, to play a motion, or to stand.
  /// Joints of the head that setHead() turns later follow that.
  void setJoint(const std::string& joint, double angle);
  /// Commands all joints limp, or to hold where they are from then on.
  void setLimp(bool limp);
  bool limp() const { return limp_; }
  /// Whether single joints are commanded, or all are limp.
  bool turnsJoints() const { return turnsJoints_; }
  /// The joints that are commanded, rad.
  const std::map<std::string, double>& joints() const { return joints_; }
  /// Commands a key-frame motion, or kGetUp; replaces a motion that has not begun.
  void play(const std::string& motion);
  /// Commands standing still: no deflection, no motion and no single joints. The head keeps its mode.
  void halt();

  /// Only an active commander commands, that is, while the user has manual control. A change of it makes a
  /// command due; deactivating also halts.
  void setActive(bool active);
  bool active() const { return active_; }

  /// Called 30 times a second. True if command() is to be sent now. `status` is what the robot reports to
  /// execute; null: nothing.
  bool tick(const robotcontrol::MotionStatus* status);
  /// The command, without its timestamp. Walking speeds are limited to a disc: full deflection is
  /// `limits().speed` in every direction.
  robotcontrol::RemoteMotion command() const;

 private:
  void releaseJoints();
  void fillJoints(robotcontrol::RemoteMotion& command) const;
  /// Ends a motion that has begun or has been commanded for a second.
  void settleMotion(const robotcontrol::MotionStatus* status);

  Limits limits_;
  WalkAxes axes_;
  /// Takes precedence over the axes.
  std::optional<Speed> velocity_;
  HeadTarget head_;
  std::map<std::string, double> joints_;
  bool turnsJoints_ = false;
  bool limp_ = false;
  /// Motion that has not begun; empty: none.
  std::string motion_;
  /// Ticks since play().
  int motionTicks_ = 0;
  bool active_ = false;
  /// Ticks since the last command.
  int sinceSent_ = 0;
  /// The last command, serialized, to detect a change.
  std::string sent_;
};

}  // namespace widgets
