// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotcontrol {
class MotionStatus;
class RemoteMotion;
}  // namespace robotcontrol

namespace widgets {

/// How far the sticks are pushed, each -1 to 1: forwards, to the left, counter-clockwise.
struct WalkAxes {
  double forward = 0;
  double left = 0;
  double turn = 0;
  bool operator==(const WalkAxes&) const = default;
  bool zero() const { return forward == 0 && left == 0 && turn == 0; }
};

/// What the head shall do; the kinds are those of robotcontrol.HeadMode, in its order. Angles in rad, for
/// kAngles.
struct HeadWish {
  enum class Kind : std::uint8_t { kLookAhead, kSearchBall, kTrackBall, kLookAround, kAngles };
  Kind kind = Kind::kLookAhead;
  double tilt = 0;
  double pan = 0;
  double roll = 0;
  double mouth = 0;
  bool operator==(const HeadWish&) const = default;
};

/// Turns what a person does with pad, keys, sliders and gamepad into motion commands, and says when one is
/// due: at once when something changed, and ten times a second (every third tick) as long as it is active, so
/// that a robot that hears nothing may stop. Key frames are commanded until the robot says that it plays them
/// (at most a second), so that they are played once. Pure; one thread.
class MotionCommander {
 public:
  struct Limits {
    double speed = 0.15;    ///< m/s at full deflection, in any direction
    double rotation = 1.0;  ///< rad/s
    bool operator==(const Limits&) const = default;
  };
  static constexpr char kGetUp[] = "get-up";

  void setLimits(Limits limits) { limits_ = limits; }
  const Limits& limits() const { return limits_; }
  void setAxes(const WalkAxes& axes) { axes_ = axes; }
  const WalkAxes& axes() const { return axes_; }
  void setHead(const HeadWish& head) { head_ = head; }
  /// A key-frame motion, or kGetUp; replaces one that has not begun.
  void play(const std::string& motion);
  /// Stands still: no deflection, no motion; the head stays.
  void halt();

  /// Only who is active commands. Starting to be does not move anything.
  void setActive(bool active);
  bool active() const { return active_; }

  /// Called 30 times a second. True: command() is to be sent now. `status` is what the robot says that it
  /// does; null if it is silent.
  bool tick(const robotcontrol::MotionStatus* status);
  /// What to send, without its time stamp.
  robotcontrol::RemoteMotion command() const;

 private:
  void settleMotion(const robotcontrol::MotionStatus* status);

  Limits limits_;
  WalkAxes axes_;
  HeadWish head_;
  std::string motion_;
  int motionTicks_ = 0;  // since it was asked for
  bool active_ = false;
  int sinceSent_ = 0;
  std::string sent_;  // the last command, serialised
};

}  // namespace widgets
