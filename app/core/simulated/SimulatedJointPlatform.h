// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/core/simulated/SimulatedPlatform.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Sensing.pb.h"

namespace app {

/// The platform of a simulated robot that moves by joints: sends its sensors' readings as packages and turns
/// its servos as requested.
///
/// Readings come every SimulatedWorld::kStep, images at the camera's rate. While STOP is engaged the joints
/// hold where they are with little torque. The true classes of an image (TrueClasses) are found only while
/// somebody receives them or is to be told of them. The world must outlive it.
class SimulatedJointPlatform final : public SimulatedPlatform {
 public:
  /// Fails if the simulated robot lacks a joint of the description.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  void alwaysSendClasses(LabeledListener listener) override;

  void actuate() override;
  std::vector<robotlink::AnySender*> onRequest() override { return {&classes_}; }

 protected:
  void execute() override;

 private:
  struct Joint {
    std::string name;
    std::size_t sensor = 0;
    std::size_t servo = 0;
    double lastAngle = 0;
  };
  SimulatedJointPlatform(SimulatedWorld& world, std::string robot);
  robotlink::Result<void> bindJoints(const robotlink::RobotDescription& description);
  void bindSensors();
  void holdStill();
  void sendJoints();
  void sendBody();
  void sendImages();
  void sendClasses(const foxglove::RawImage& image);

  std::vector<Joint> joints_;
  std::vector<std::size_t> cameras_;
  std::vector<std::size_t> contacts_;
  int accelerometer_ = -1;
  int distance_ = -1;
  bool holding_ = false;
  bool classesAlways_ = false;
  LabeledListener labeledListener_;

  robotlink::Sender<foxglove::RawImage> image_;
  robotlink::Sender<foxglove::RawImage> classes_;
  robotlink::Sender<foxglove::JointStates> jointStates_;
  robotlink::Sender<robotcontrol::BodySensors> bodySensors_;
  robotlink::Receiver<robotcontrol::JointRequest> jointRequest_;
};

}  // namespace app
