// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "modules/motion/FallDetector.h"
#include "modules/motion/JointLayout.h"
#include "modules/motion/WheelModelGait.h"
#include "robotlink/motions/MotionPlayer.h"

namespace modules {

/// A request for the body. A plain value.
struct MotionCommand {
  enum class Kind { kStand, kWalk, kKeyFrames, kGetUp, kJoints };
  Kind kind = Kind::kStand;
  /// Only for kWalk; zero means standing.
  WalkSpeed walk;
  /// Only for kKeyFrames.
  std::string motion;
  /// Only for kJoints: the angle of each joint in rad, in the order of the robot's description; NaN, or a
  /// joint beyond the list, holds its angle.
  std::vector<double> joints = {};
  /// Only for kJoints: all joints are limp instead.
  bool limp = false;
  bool operator==(const MotionCommand&) const = default;
};

/// Converts requests to angles of all joints, one frame at a time: stands, walks, plays key-frame motions,
/// gets up, turns single joints, and blends between them without jumps. It is the core of the task `motion`,
/// independent of packages and debugging.
///
/// A walk stops before joints turn, and before key frames begin whose file does not say that they begin in
/// a walk; a key-frame motion is left only at its transitions. With `getUpByItself`, a fallen robot first
/// gets up, whatever is requested, unless its joints are turned one by one, as when it is posed by hand.
/// Deterministic. Not thread-safe.
class MotionEngine {
 public:
  struct Options {
    bool getUpByItself = true;
    /// The time from the end of a motion to the stand, s.
    double blendTime = 0.5;
    /// Fraction of the head joints' maximal speed.
    double headSpeedShare = 0.9;
    bool operator==(const Options&) const = default;
  };
  /// The input of a frame.
  struct Frame {
    MotionCommand desired;
    HeadAngles head;
    /// Null if it is unknown.
    const robotlink::Vector3* acceleration = nullptr;
    /// The duration of the frame.
    robotlink::Duration time = std::chrono::milliseconds(8);
    /// The measured angles of all joints, which limp joints follow; empty: unknown.
    std::span<const double> measured = {};
  };

  /// Starts in the robot's stance.
  MotionEngine(JointLayout joints, std::shared_ptr<const robotlink::MotionNet> motions,
               const GaitParameters& gait, Options options);

  /// Sets the present angles of the joints; call it before the first frame if they are known.
  void start(std::span<const double> positions);
  /// Replaces the motions; one that is being played is played to its end first.
  void setMotions(std::shared_ptr<const robotlink::MotionNet> motions) { motions_ = std::move(motions); }
  /// Takes effect with the next frame.
  void setParameters(const GaitParameters& gait, Options options);
  /// Advances by a frame; the results are read with the functions below.
  void advance(const Frame& frame);

  /// In rad, in the order of the robot's description.
  std::span<const double> positions() const { return positions_; }
  /// Fraction of the torque, the same for all servos.
  double stiffness() const { return stiffness_; }
  /// The request that is being executed, which may differ from the last one.
  const MotionCommand& executed() const { return executed_; }
  /// Whether the present motion can be left now.
  bool stable() const;
  /// The pose by dead reckoning since start(): the speeds of the gait, and what motions say of themselves.
  const robotlink::Pose2& odometry() const { return odometry_; }
  /// The robot's present velocity according to the gait.
  WalkSpeed speed() const;
  const FallDetector& falls() const { return falls_; }
  const WheelModelGait& gait() const { return gait_; }
  /// The reason why the request is not executed: "there is no motion 'x'"; empty if it is.
  const std::string& refusal() const { return refusal_; }

 private:
  /// The source of the leg motions.
  enum class Mode { kGait, kKeyFrames, kJoints };
  /// The request as it can be executed.
  MotionCommand resolved(const MotionCommand& desired);
  /// Whether the gait is in what the key-frame motion begins in.
  bool mayBegin(const std::string& motion) const;
  /// The name of the motion for the side on which the robot lies.
  std::string getUpMotion() const;
  void runGait(const MotionCommand& desired, robotlink::Duration time);
  /// Starts moving the legs from their present angles to the stand.
  void beginBlend();
  void runKeyFrames(const MotionCommand& desired, robotlink::Duration time);
  void countKeyFrames(robotlink::Duration time);
  void runJoints(const MotionCommand& desired, std::span<const double> measured, double seconds);
  void moveHead(const HeadAngles& wanted, double seconds);
  /// Moves joints that nothing controls to their stance.
  void setFreeJoints(double seconds);

  JointLayout joints_;
  std::shared_ptr<const robotlink::MotionNet> motions_;
  WheelModelGait gait_;
  robotlink::MotionPlayer player_;
  FallDetector falls_;
  Options options_;
  Mode mode_ = Mode::kGait;
  std::vector<double> positions_;
  /// The angles when the blend began.
  std::vector<double> blendFrom_;
  /// Time since the blend began, s.
  double blended_ = 0;
  double stiffness_ = 1;
  robotlink::Pose2 odometry_;
  MotionCommand executed_;
  std::string refusal_;
  /// The key-frame motion whose displacement is being added to odometry_.
  struct Played {
    std::string motion;
    /// The odometry at its begin.
    robotlink::Pose2 begin;
    robotlink::MotionNet::Displacement displacement;
    robotlink::Duration elapsed{};
  };
  Played played_;
};

}  // namespace modules
