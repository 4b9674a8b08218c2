// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotlink/base/Geometry.h"

namespace modules {

/// What a behaviour knows of its robot and the world at one instant. Robot frame unless it says otherwise.
struct Situation {
  double time = 0;  ///< s, of any clock
  bool ballKnown = false;
  robotlink::Vector2 ball = robotlink::Vector2::Zero();  ///< m
  double ballAge = 0;                                    ///< s since it was seen
  /// Where the opponent's goal is; none while the robot does not know where it is itself.
  std::optional<robotlink::Vector2> goal;
  bool fieldSeen = false;  ///< the camera shows colours of the field: it is not blind
  bool fallen = false;
  bool kicking = false;  ///< motion plays key frames
  bool stable = true;    ///< the motion can be left now
};

/// What it wants of the robot.
struct Intention {
  enum class Motion { kStand, kWalk, kKick, kGetUp };
  enum class Head { kAhead, kSearch, kTrack, kLookAround };
  Motion motion = Motion::kStand;
  double forward = 0, left = 0;  ///< m/s
  double turn = 0;               ///< rad/s, counter-clockwise
  Head head = Head::kAhead;
  bool operator==(const Intention&) const = default;
};

/// Goes to the ball and kicks it: a state machine on plain values.
///
/// Searching: looks about standing, then turns on the spot; it leaves the spot only after a whole turn, for a
/// bounded way, and only if it sees the field: a blind robot stands still. Approaching: turns to the ball and
/// walks to a place behind it, seen from the goal if that is known. Aligning: circles around the ball until
/// the goal is behind it. Positioning: the last centimetres to where the kicking paw reaches the ball.
/// Kicking: one key-frame motion, then the ball is looked for anew. A robot that fell gets up.
class BallChaser {
 public:
  enum class State {
    kBlind,
    kLookAbout,
    kTurn,
    kWander,
    kApproach,
    kGlance,
    kAlign,
    kPosition,
    kKick,
    kGetUp
  };
  struct Options {
    double forwardSpeed = 0.15, sidewardSpeed = 0.10;  ///< m/s
    double turnSpeed = 0.9;                            ///< rad/s
    double lookAboutTime = 2.5;                        ///< s
    double turnTime = 9;                               ///< s, for a bit more than a whole turn
    double wanderTime = 4;                             ///< s
    double wanderSpeed = 0.1;                          ///< m/s
    double blindAfter = 1.0;                           ///< s without the field's colours
    double lostAfter = 4;                              ///< s without the ball
    double glanceTime = 2.5;                           ///< s, for beacons and goals
    double glanceAgain = 12;                           ///< s, after the last glance
    double alignDistance = 0.32;                       ///< m, from the ball's middle while circling it
    double alignTolerance = 0.35;                      ///< rad, between ball and goal
    double alignTime = 8;                              ///< s, then it kicks wherever the ball goes
    double kickX = 0.155, kickY = 0.0;                 ///< m, where the ball must be
    double kickToleranceX = 0.02, kickToleranceY = 0.03;
    double positionTime = 8;  ///< s, then it begins anew
    double kickTimeout = 5;   ///< s
  };
  explicit BallChaser(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  Intention decide(const Situation& now);
  State state() const { return state_; }
  /// Why the state was entered.
  const std::string& reason() const { return reason_; }
  /// The last decide() entered it.
  bool changed() const { return changed_; }
  /// Where it wants to stand, in the robot's frame; for drawings.
  const std::optional<robotlink::Vector2>& target() const { return target_; }

 private:
  void enter(State state, const char* reason, double time);
  void transit(const Situation& now);
  void transitSearch(const Situation& now);
  void transitChase(const Situation& now);
  void transitKick(const Situation& now);
  bool seesBall(const Situation& now) const { return now.ballKnown && now.ballAge < 0.3; }
  /// The angle between the ball and the goal behind it, seen from the robot; none if the goal is not known.
  std::optional<double> misalignment(const Situation& now) const;

  Intention act(const Situation& now);
  Intention approach(const Situation& now);
  Intention align(const Situation& now) const;
  Intention position(const Situation& now) const;
  Intention walk(const robotlink::Vector2& way, double turn, double speedShare) const;

  Options options_;
  State state_ = State::kLookAbout;
  double enteredAt_ = 0;
  bool started_ = false;
  double fieldSeenAt_ = 0;
  bool kickBegan_ = false;
  double glancedAt_ = -1e9;
  double turnDirection_ = 1;
  std::string reason_;
  bool changed_ = false;
  std::optional<robotlink::Vector2> target_;
};

const char* name(BallChaser::State state);

}  // namespace modules
