// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "modules/motion/FallDetector.h"
#include "modules/motion/Legs.h"
#include "robotlink/base/Clock.h"

namespace modules {

/// Detected events of the robot's body: picked up, fallen, collided. A plain value.
struct BodyEvents {
  bool pickedUp = false;
  bool fallen = false;
  FallDetector::Side side = FallDetector::Side::kNone;
  /// In the order of kLegs.
  std::array<bool, 4> collided{};
  bool operator==(const BodyEvents&) const = default;
};

/// The inputs of the detectors of a body's events in a frame. Angles in the order of kLegs.
struct BodyFrame {
  robotlink::Duration time = std::chrono::milliseconds(8);
  /// In the body's frame, m/s^2.
  robotlink::Vector3 acceleration{0, 0, 9.81};
  std::array<bool, 4> contacts{true, true, true, true};
  std::array<LegAngles, 4> measured;
  /// The angles requested of the joints at the time at which these angles were measured.
  std::array<LegAngles, 4> requested;
  /// The torques of the knees, N m; all 0 where they are not measured.
  std::array<double, 4> kneeTorques{};
  /// The robot walks.
  bool walking = false;
  /// The robot is playing a key-frame motion or getting up, so its leg motion is unusual.
  bool shaken = false;
};

/// Judges by the foot switches and the accelerometer. Without any contact for a while, the robot was picked
/// up; the direction of gravity says on which side it lies (FallDetector). A leg that should step but keeps
/// its contact, or has none, for longer than a step has collided. Not thread-safe.
class ContactEvents {
 public:
  struct Options {
    /// The time without ground contact after which the robot counts as picked up, and that with contact after
    /// which it counts as put down, s.
    double pickedUpAfter = 0.3, putDownAfter = 0.1;
    /// The time for which a paw of a walking robot keeps its contact until its leg has collided, s.
    double stuckAfter = 1.2;
  };
  explicit ContactEvents(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame.
  const BodyEvents& update(const BodyFrame& frame);

 private:
  Options options_;
  FallDetector falls_;
  BodyEvents events_;
  /// For how long no paw, or any paw, has touched the ground, s.
  double lifted_ = 0, standing_ = 0;
  std::array<bool, 4> contacts_{};
  /// For how long a paw has kept its contact while the robot walks, s.
  std::array<double, 4> kept_{};
};

/// Judges by what the joints exert, and by the differences of requested and measured angles. The knees bear
/// the body; where they do not, the robot was picked up. A leg whose joints lag far more than they usually do
/// in walking has collided (Quinlan, Murch, Middleton, Chalup: Traction monitoring for collision detection
/// with legged robots, RoboCup 2003). Not thread-safe.
class JointErrorEvents {
 public:
  struct Options {
    /// The least torque of the knees that bear the body, averaged over legs and time, N m.
    double load = 0.06;
    /// Over which time that is averaged, s.
    double loadTime = 0.5;
    /// The number of standard deviations above its mean that the error of a leg has when it has collided.
    double deviations = 4;
    /// Over which time the present error, and the usual one, are averaged, s.
    double errorTime = 0.15, usualTime = 6;
    /// The time of walking until the usual errors of the robot are known, s.
    double learningTime = 2;
  };
  explicit JointErrorEvents(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame.
  const BodyEvents& update(const BodyFrame& frame);
  /// The averaged torque of the knees, N m.
  double load() const { return load_; }
  /// The present error of a leg in standard deviations above its mean.
  double excess(Leg leg) const { return legs_[index(leg)].excess; }

 private:
  struct LegError {
    /// Averages in rad and rad^2: of the last moments, of the last seconds, and of their deviation.
    double now = 0, mean = 0, variance = 0;
    double excess = 0;
  };
  void updateLoad(const BodyFrame& frame, double seconds);
  void updateErrors(const BodyFrame& frame, double seconds);

  Options options_;
  FallDetector falls_;
  BodyEvents events_;
  double load_ = 0;
  /// Whether the load is an average of enough time, s.
  double loadKnown_ = 0;
  /// For how long the robot has walked without a break, s.
  double walked_ = 0;
  std::array<LegError, 4> legs_;
};

}  // namespace modules
