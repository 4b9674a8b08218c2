// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "modules/motion/MotionEngine.h"
#include "robotlink/debugging/Solution.h"

namespace robotcontrol {
class GaitMotionParameters;
}

namespace modules {

/// The solutions of the task `motion`: they connect a MotionEngine to packages, and differ in the curve of
/// the paws.
///
/// Each execution sends one frame of joint angles. If the motions (resources/motions) do not compile, the
/// errors are logged and the robot can only stand and walk. Frames have 8 ms of the platform's clock; missed
/// frames are made up for, up to 40 ms.
class MotionSolution : public robotlink::Solution {
 public:
  MotionSolution(robotlink::SolutionContext& context, FootMode mode);
  ~MotionSolution() override;
  void execute() override;

 private:
  /// Creates the engine, at the first execution.
  void create();
  std::shared_ptr<const robotlink::MotionNet> motions(const std::vector<std::string>& joints);
  /// Gives the engine the motions that a user has sent.
  void takeMotions();
  std::vector<double> measured() const;
  std::vector<double> desiredJoints();
  /// The time since the last execution, in whole frames.
  robotlink::Duration frameTime();
  MotionEngine::Frame frame(robotlink::Duration time);
  void sendJoints();
  void sendStatus();
  /// Logs changes of motion, falls and refusals.
  void publish();
  void plot();
  void draw();

  robotlink::SolutionContext& context_;
  FootMode mode_;
  robotlink::Input<robotcontrol::MotionRequest> request_;
  robotlink::Input<robotcontrol::HeadRequest> head_;
  robotlink::Input<foxglove::JointStates> joints_;
  robotlink::Input<robotcontrol::BodySensors> sensors_;
  robotlink::Input<robotcontrol::MotionTexts> texts_;
  robotlink::Output<robotcontrol::JointRequest> jointRequest_;
  robotlink::Output<robotcontrol::MotionStatus> status_;
  const robotcontrol::GaitMotionParameters& parameters_;
  std::unique_ptr<MotionEngine> engine_;
  /// The last known acceleration; initially level and at rest.
  robotlink::Vector3 acceleration_{0, 0, 9.81};
  robotlink::Instant last_;
  /// The measured angles of the joints, while they are limp.
  std::vector<double> measured_;
  /// Whether the engine has got the angles of the joints.
  bool started_ = false;
  // The last logged state, so that only changes are logged.
  std::string reportedRefusal_;
  std::string reportedMotion_;
  std::string reportedJoint_;
  bool reportedFallen_ = false;
};

}  // namespace modules
