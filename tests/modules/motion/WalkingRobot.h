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
/// That of another file there: "wheel-model-fast".
GaitParameters shippedGait(const std::filesystem::path& resources, const std::string& solution,
                           FootMode mode);

/// An ERS-210 in the physics of the field, moved by a MotionEngine without a robot program, for tests and
/// measurements of motion. Frames of 8 ms. If something cannot be loaded, the test program prints an error
/// and ends.
class WalkingRobot {
 public:
  struct Options {
    GaitParameters gait;
    MotionEngine::Options motion;
    std::uint64_t seed = 1;
    /// The folder `resources` of the project.
    std::filesystem::path resources;
    /// A scene with one robot and a ball; empty: the field of 2002.
    std::filesystem::path scene;
  };
  /// The mean velocity in the robot's frame, and the minimum z-component of the body's z-axis (1 is upright).
  struct Measured {
    WalkSpeed speed;
    double leastUpright = 1;
  };

  explicit WalkingRobot(const Options& options);

  void frame(const MotionCommand& desired);
  /// Executes frames with the same request for some seconds.
  void run(const MotionCommand& desired, double seconds);
  /// Walks from the field's center until the speed is steady, then measures.
  Measured walk(const WalkSpeed& speed, double seconds);

  simcore::Simulation& simulation() { return *simulation_; }
  const MotionEngine& engine() const { return *engine_; }
  HeadAngles& head() { return head_; }
  robotlink::Pose3 pose() const { return *simulation_->modelPose(robot_); }
  double upright() const { return pose().linear()(2, 2); }
  robotlink::Vector3 ball() const { return simulation_->modelPose("ball")->translation(); }
  void placeRobot(const robotlink::Pose2& pose);
  /// `position` is in the robot's frame.
  void placeBall(const robotlink::Vector2& position);

 private:
  std::unique_ptr<simcore::Simulation> simulation_;
  std::string robot_;
  std::unique_ptr<MotionEngine> engine_;
  /// Indexed by joint.
  std::vector<std::size_t> servos_;
  /// Sensors, indexed by joint.
  std::vector<std::size_t> angles_;
  std::size_t accelerometer_ = 0;
  HeadAngles head_{robotlink::radians(-12), 0, 0, robotlink::radians(-3)};
};

}  // namespace modules
