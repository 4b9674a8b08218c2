// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "modules/motion/FallDetector.h"
#include "modules/motion/JointLayout.h"
#include "modules/motion/WheelModelGait.h"
#include "robotlink/motions/MotionPlayer.h"

namespace modules {

/// What is wanted of the body. A plain value.
struct MotionWish {
  enum class Kind { kStand, kWalk, kKeyFrames, kGetUp };
  Kind kind = Kind::kStand;
  WalkSpeed walk;      ///< for kWalk; zero is standing
  std::string motion;  ///< for kKeyFrames
  bool operator==(const MotionWish&) const = default;
};

/// Turns wishes into the angles of all joints, one frame at a time: stands, walks, plays key-frame motions,
/// gets up, and passes from one to the other without jumps. The engine of the task `motion`, free of packages
/// and debugging.
///
/// A walk comes to a stand before key frames begin; a motion that has begun is left at its transitions only.
/// A robot that fell gets up first, whatever else is wanted, if `getUpByItself`. Deterministic: its calls
/// decide everything.
class MotionEngine {
 public:
  struct Options {
    bool getUpByItself = true;
    double blendTime = 0.5;       ///< s, from the end of a motion to the stand
    double headSpeedShare = 0.9;  ///< of the head joints' greatest speed
    bool operator==(const Options&) const = default;
  };
  struct Frame {
    MotionWish wish;
    HeadAngles head;
    const robotlink::Vector3* acceleration = nullptr;  ///< null if it is not known anew
    robotlink::Duration time = std::chrono::milliseconds(8);
  };

  MotionEngine(JointLayout joints, std::shared_ptr<const robotlink::MotionNet> motions,
               const GaitParameters& gait, Options options);

  /// The joints are at these angles; to be called before the first frame if they are known.
  void start(std::span<const double> positions);
  void setParameters(const GaitParameters& gait, Options options);
  void advance(const Frame& frame);

  /// rad, in the order of the robot's description.
  std::span<const double> positions() const { return positions_; }
  /// Share of the torque for all servos.
  double stiffness() const { return stiffness_; }
  const MotionWish& executed() const { return executed_; }
  bool stable() const;
  /// Dead reckoning since start().
  const robotlink::Pose2& odometry() const { return odometry_; }
  WalkSpeed speed() const;
  const FallDetector& falls() const { return falls_; }
  const WheelModelGait& gait() const { return gait_; }
  /// Why the wish is not fulfilled: "there is no motion 'x'"; empty if it is.
  const std::string& refusal() const { return refusal_; }

 private:
  enum class Mode { kGait, kKeyFrames };
  MotionWish resolved(const MotionWish& wish);
  std::string getUpMotion() const;
  void runGait(const MotionWish& wish, robotlink::Duration time);
  void beginBlend();
  void runKeyFrames(const MotionWish& wish, robotlink::Duration time);
  void moveHead(const HeadAngles& wanted, double seconds);
  void setFreeJoints(double seconds);

  JointLayout joints_;
  std::shared_ptr<const robotlink::MotionNet> motions_;
  WheelModelGait gait_;
  robotlink::MotionPlayer player_;
  FallDetector falls_;
  Options options_;
  Mode mode_ = Mode::kGait;
  std::vector<double> positions_;
  std::vector<double> blendFrom_;
  double blended_ = 0;  ///< s since the blend began
  double stiffness_ = 1;
  robotlink::Pose2 odometry_;
  MotionWish executed_;
  std::string refusal_;
};

}  // namespace modules
