// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/core/SimulatedWorld.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/process/Platform.h"

namespace app {

/// The platform of one robot of a simulated world: sends its sensors' readings as packages and turns its servos as requested.
///
/// Readings come every SimulatedWorld::kStep, images at the camera's rate. While STOP is engaged the joints hold where they are
/// with little torque. The true classes of an image (TrueClasses) are found only while somebody receives them or is
/// to be told of them. The world must outlive it.
class SimulatedPlatform final : public robotlink::Platform {
 public:
  /// Fails if the simulated robot lacks a joint of the description.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  using LabelledListener = std::function<void(const foxglove::RawImage& image, const foxglove::RawImage& classes)>;
  /// Sends the true classes with every image from now on, whether or not somebody receives them; the listener, which
  /// may be empty, is told of both.
  void alwaysSendClasses(LabelledListener listener);

  void actuate() override;
  void engageStop(bool engaged) override { stopEngaged_.store(engaged); }
  std::vector<robotlink::AnySender*> onRequest() override { return {&classes_}; }
  bool stopEngaged() const { return stopEngaged_.load(); }

 protected:
  void execute() override;

 private:
  struct Joint {
    std::string name;
    std::size_t sensor = 0;
    std::size_t servo = 0;
    double lastAngle = 0;
  };
  SimulatedPlatform(SimulatedWorld& world, std::string robot);
  robotlink::Result<void> bindJoints(const robotlink::RobotDescription& description);
  void bindSensors();
  void holdStill();
  void sendJoints();
  void sendBody();
  void sendImages();
  void sendClasses(const foxglove::RawImage& image);
  void sendOracle();

  SimulatedWorld& world_;
  std::string robot_;
  std::vector<Joint> joints_;
  std::vector<std::size_t> cameras_;
  std::vector<std::size_t> contacts_;
  int accelerometer_ = -1;
  int distance_ = -1;
  std::atomic<bool> stopEngaged_{false};
  bool holding_ = false;
  bool classesAlways_ = false;
  LabelledListener labelledListener_;

  robotlink::Sender<foxglove::RawImage> image_;
  robotlink::Sender<foxglove::RawImage> classes_;
  robotlink::Sender<foxglove::JointStates> jointStates_;
  robotlink::Sender<robotcontrol::BodySensors> bodySensors_;
  robotlink::Sender<robotcontrol::OracleWorld> oracle_;
  robotlink::Receiver<robotcontrol::JointRequest> jointRequest_;
};

/// "blue" for robots whose name starts so, else "red".
std::string teamOf(const std::string& robot);

}  // namespace app
