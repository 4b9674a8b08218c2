// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "modules/motion/JointLayout.h"
#include "modules/motion/RobotDimensions.h"
#include "robotlink/base/Clock.h"

namespace modules {

/// What is wanted of the head.
struct HeadWish {
  enum class Kind { kLookAhead, kSearchBall, kTrackBall, kLookAround, kAngles };
  Kind kind = Kind::kLookAhead;
  HeadAngles angles;  ///< for kAngles
  bool operator==(const HeadWish&) const = default;
};

/// What the ball model says: where the ball is in the robot's frame (m), and for how long nobody has seen it
/// (s).
struct BallSight {
  robotlink::Vector2 position{0, 0};
  double age = 0;
};

struct HeadParameters {
  double bodyHeight = 0.115;  ///< m, of the body's origin above the ground
  double bodyPitch = 0.046;   ///< rad, nose down
  double ballRadius = 0.042;  ///< m
  double aheadTilt = robotlink::radians(-12);
  double searchFarTilt = robotlink::radians(-14);   ///< the sweep that sees the field
  double searchNearTilt = robotlink::radians(-42);  ///< the sweep that sees the ground before the paws
  double searchFarPan = robotlink::radians(80), searchNearPan = robotlink::radians(55);
  double aroundTilt = robotlink::radians(-2);  ///< beacons and goals
  double aroundPan = robotlink::radians(85);
  double sweepSpeed = 1.9;  ///< rad/s
  double lostAfter = 0.7;   ///< s since it was seen, then the ball is searched
  bool operator==(const HeadParameters&) const = default;
};

/// Decides where the head looks: ahead, at given angles, around in sweeps, or at the ball, which it searches
/// when it is lost.
///
/// Searching sweeps from side to side, once far and once near, beginning on the side where the ball was last.
/// A pure function of its calls. Angles in rad; the motion task limits them to what the joints can do.
class HeadController {
 public:
  explicit HeadController(const HeadParameters& parameters, const RobotDimensions& dimensions = {})
      : parameters_(parameters), dimensions_(dimensions) {}

  void setParameters(const HeadParameters& parameters) { parameters_ = parameters; }
  /// `now`: where the head is; `ball`: empty if it is unknown.
  HeadAngles advance(const HeadWish& wish, const std::optional<BallSight>& ball, const HeadAngles& now,
                     robotlink::Duration frame);
  /// The sweep from side to side alone.
  HeadAngles lookAround(const HeadAngles& now, robotlink::Duration frame);
  /// Angles with which the camera's axis goes through a point of the robot's frame, as far as the neck
  /// allows.
  HeadAngles anglesTowards(const robotlink::Vector3& pointInRobot) const;

  enum class State { kStill, kTracking, kSearching, kSweeping };
  State state() const { return state_; }

 private:
  struct Waypoint {
    double tilt, pan;
  };
  HeadAngles swept(const std::vector<Waypoint>& path, State state, const HeadAngles& now, double seconds);

  HeadParameters parameters_;
  RobotDimensions dimensions_;
  State state_ = State::kStill;
  std::size_t waypoint_ = 0;
  double side_ = 1;   ///< where searching begins: 1 left, -1 right
  HeadAngles sweep_;  ///< where the sweep is
};

}  // namespace modules
