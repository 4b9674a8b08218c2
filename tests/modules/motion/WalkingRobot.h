// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "modules/motion/MotionEngine.h"
#include "simcore/Simulation.h"

namespace modules {

/// The gait of resources/parameters/ers210/motion.wheel-model-*.textproto.
GaitParameters shippedGait(const std::filesystem::path& resources, FootMode mode);

/// An ERS-210 in the physics of the field, moved by a MotionEngine without the robot program around it: for
/// tests and measurements of motion. Frames of 8 ms; what cannot be loaded is a failure of the whole test
/// program, told on stderr.
class WalkingRobot {
 public:
  struct Options {
    GaitParameters gait;
    MotionEngine::Options motion;
    std::uint64_t seed = 1;
    std::filesystem::path resources;  ///< the project's folder of resources
    std::filesystem::path scene;      ///< of one robot and a ball; empty is the field of 2002
  };
  /// Mean velocity in the robot's own frame, and how far it tilted (the height of the body's z-axis, 1 is
  /// upright).
  struct Measured {
    WalkSpeed speed;
    double leastUpright = 1;
  };

  explicit WalkingRobot(const Options& options);

  void frame(const MotionWish& wish);
  /// Frames with a wish for some seconds.
  void run(const MotionWish& wish, double seconds);
  /// Walks from the field's centre until the speed is steady, and measures.
  Measured walk(const WalkSpeed& speed, double seconds);

  simcore::Simulation& simulation() { return *simulation_; }
  const MotionEngine& engine() const { return *engine_; }
  HeadAngles& head() { return head_; }
  robotlink::Pose3 pose() const { return *simulation_->modelPose(robot_); }
  double upright() const { return pose().linear()(2, 2); }
  robotlink::Vector3 ball() const { return simulation_->modelPose("ball")->translation(); }
  void placeRobot(const robotlink::Pose2& pose);
  /// `position` in the robot's frame.
  void placeBall(const robotlink::Vector2& position);

 private:
  std::unique_ptr<simcore::Simulation> simulation_;
  std::string robot_;
  std::unique_ptr<MotionEngine> engine_;
  std::vector<std::size_t> servos_;  // by joint
  std::vector<std::size_t> angles_;  // sensors by joint
  std::size_t accelerometer_ = 0;
  HeadAngles head_{robotlink::radians(-12), 0, 0, robotlink::radians(-3)};
};

}  // namespace modules
