// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "modules/motion/MotionEngine.h"
#include "robotlink/debugging/Solution.h"

namespace robotcontrol {
class GaitMotionParameters;
}

namespace modules {

/// The solutions of the task `motion`: a MotionEngine between packages. They differ in the curve of the paws.
///
/// A frame of joint angles is sent each time it runs. Without motions (resources/motions does not compile)
/// the errors are told and the robot can still stand and walk. Frames are 8 ms by the platform's clock; what
/// is missed is made up for, up to 40 ms.
class MotionSolution : public robotlink::Solution {
 public:
  MotionSolution(robotlink::SolutionContext& context, FootMode mode);
  ~MotionSolution() override;
  void execute() override;

 private:
  void create();
  void readParameters();
  robotlink::Duration frameTime();
  MotionEngine::Frame frame(robotlink::Duration time);
  void sendJoints();
  void sendStatus();
  void tell();
  void plot();
  void draw();

  robotlink::SolutionContext& context_;
  FootMode mode_;
  robotlink::Input<robotcontrol::MotionRequest> request_;
  robotlink::Input<robotcontrol::HeadRequest> head_;
  robotlink::Input<foxglove::JointStates> joints_;
  robotlink::Input<robotcontrol::BodySensors> sensors_;
  robotlink::Output<robotcontrol::JointRequest> jointRequest_;
  robotlink::Output<robotcontrol::MotionStatus> status_;
  const robotcontrol::GaitMotionParameters& parameters_;
  std::unique_ptr<MotionEngine> engine_;
  robotlink::Vector3 acceleration_{0, 0, 9.81};
  robotlink::Instant last_;
  bool started_ = false;
  std::string toldRefusal_;
  std::string toldMotion_;
  bool toldFallen_ = false;
};

}  // namespace modules
