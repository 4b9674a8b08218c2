// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "modules/motion/JointLayout.h"
#include "modules/motion/Legs.h"
#include "robotlink/base/Clock.h"

namespace modules {

/// A request for the head.
struct HeadCommand {
  enum class Kind { kLookAhead, kSearchBall, kTrackBall, kLookAround, kAngles };
  Kind kind = Kind::kLookAhead;
  /// Only for kAngles.
  HeadAngles angles;
  bool operator==(const HeadCommand&) const = default;
};

/// The ball model as the head needs it: the ball's position in the robot's frame, m, and the time since it
/// was seen, s.
struct BallSight {
  robotlink::Vector2 position{0, 0};
  double age = 0;
};

/// Dimensions, angles and speeds of looking.
struct HeadParameters {
  /// Height of the body's origin above the ground, m.
  double bodyHeight = 0.115;
  /// Nose down, rad.
  double bodyPitch = 0.046;
  /// Meters.
  double ballRadius = 0.042;
  // Tilt is positive upward.
  double aheadTilt = robotlink::radians(-12);
  /// The sweep that sees the far field.
  double searchFarTilt = robotlink::radians(-14);
  /// The sweep that sees the ground in front of the paws.
  double searchNearTilt = robotlink::radians(-42);
  double searchFarPan = robotlink::radians(80), searchNearPan = robotlink::radians(55);
  /// Beacons and goals are at this height.
  double aroundTilt = robotlink::radians(-2);
  double aroundPan = robotlink::radians(85);
  /// Radians per second.
  double sweepSpeed = 1.9;
  /// Time of looking at where the ball should be, without seeing it, before it is searched, s.
  double lostAfter = 0.7;
  /// The angle below the image's middle at which a tracked ball is kept if landmarks are higher, rad. A
  /// ball before the paws is kept in the middle.
  double ballLow = 0.2;
  bool operator==(const HeadParameters&) const = default;
};

/// Controls where the head looks: ahead, at given angles, around in sweeps, or at the ball, which is searched
/// when it is lost.
///
/// The search sweeps from side to side, alternately far and near, starting at the side where the ball was
/// last, and near if the ball was. The result depends only on the calls. Angles in rad; the motion task
/// limits them to the range of the joints. Not thread-safe.
class HeadController {
 public:
  explicit HeadController(const HeadParameters& parameters, const RobotDimensions& dimensions = {})
      : parameters_(parameters), dimensions_(dimensions) {}

  void setParameters(const HeadParameters& parameters) { parameters_ = parameters; }
  /// Call it once a frame. `now` are the present angles; `ball` is empty if it is unknown.
  HeadAngles advance(const HeadCommand& desired, const std::optional<BallSight>& ball, const HeadAngles& now,
                     robotlink::Duration frame);
  /// Only the sweep from side to side.
  HeadAngles lookAround(const HeadAngles& now, robotlink::Duration frame);
  /// The angles with which the camera's axis points at a point in the robot's frame, as far as the neck
  /// allows.
  HeadAngles anglesTowards(const robotlink::Vector3& pointInRobot) const;
  /// The angles with which it tracks a ball there, in the robot's frame, m.
  HeadAngles tracking(const robotlink::Vector2& ball) const;

  /// For drawings and logs.
  enum class State { kStill, kTracking, kSearching, kSweeping };
  State state() const { return state_; }

 private:
  /// A corner of a sweep, rad.
  struct Waypoint {
    double tilt, pan;
  };
  /// Advances a sweep along a closed path.
  HeadAngles swept(const std::vector<Waypoint>& path, State state, const HeadAngles& now, double seconds);

  HeadParameters parameters_;
  RobotDimensions dimensions_;
  State state_ = State::kStill;
  /// Index of the next corner.
  std::size_t waypoint_ = 0;
  /// The side where a search begins: 1 left, -1 right.
  double side_ = 1;
  bool searchesNear_ = false;
  /// The time for which it has looked at the ball's place without seeing it, s.
  double lookedFor_ = 0;
  /// The present target of the sweep.
  HeadAngles sweep_;
};

}  // namespace modules
