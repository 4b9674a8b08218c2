// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/platform/CameraSettingsSender.h"
#include "app/platforms/simulated/SimulatedPlatform.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"

namespace app {

/// The platform of a simulated robot that moves by joints: sends the readings of its sensors as packages, and
/// sets its servos to the requested angles.
///
/// Where the scene moves the robot without forces, it also receives what the gait makes of the requested
/// walk, and has the simulation move the body so; the program does the same as ever.
///
/// Readings are sent every SimulatedWorld::kStep, images at the rate of the camera. While STOP is engaged,
/// the joints hold their angles with little torque. The true classes of an image (TrueClasses) are computed
/// only if a receiver or listener needs them. The world must outlive it.
class SimulatedJointPlatform final : public SimulatedPlatform {
 public:
  /// Fails if the simulated robot lacks a joint of the description.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  bool rebind() override;
  void alwaysSendClasses(LabeledListener listener) override;

  /// Sets the servos to the latest request, or holds still while STOP is engaged.
  void actuate() override;
  std::vector<robotlink::AnySender*> onRequest() override { return {&classes_, settings_.sender()}; }
  /// For all cameras of the robot.
  robotlink::Result<void> setCamera(const robotcontrol::SetCamera& details) override;

 protected:
  /// Sends the readings, and images that are due.
  void execute() override;

 private:
  /// A joint of the description with the indices of its ports in the simulation.
  struct Joint {
    std::string name;
    std::size_t sensor = 0;
    std::size_t servo = 0;
    /// The angle in the last step, rad, for the velocity; NaN before the first step.
    double lastAngle = 0;
  };
  SimulatedJointPlatform(SimulatedWorld& world, std::string robot);
  /// Finds the ports of the joints.
  robotlink::Result<void> bindJoints(const robotlink::RobotDescription& description);
  /// Finds cameras, paw contacts, accelerometer and distance sensor, as far as the robot has them.
  void bindSensors();
  /// Finds the port that moves the body, if the scene moves it without forces.
  void bindWalk();
  /// Finds it again among other models; false if the scene has begun or ceased to move the body so.
  bool rebindWalk();
  /// The guide that moves the body, if there is one.
  std::optional<std::size_t> walkPort() const;
  /// Commands that port.
  void walk(double x, double y, double rotation);
  /// Requests the current angles with little torque, once per STOP.
  void holdStill();
  /// Sends joints/states, with angles in rad and velocities in rad/s.
  void sendJoints();
  /// Sends oracle/state.
  void sendTrueState();
  /// Sends the readings of the body's sensors.
  void sendBody();
  /// Sends the images of cameras that are due, with their true classes if these are wanted.
  void sendImages();
  robotcontrol::CameraSettings cameraSettings() const;
  /// Sends the true classes of the image that was rendered last.
  void sendClasses(const foxglove::RawImage& image);

  /// In the order of the description, which is that of JointRequest.positions.
  std::vector<Joint> joints_;
  /// Indices of sensors in the simulation; -1 if there is none.
  std::vector<std::size_t> cameras_;
  std::vector<std::size_t> contacts_;
  int accelerometer_ = -1;
  int distance_ = -1;
  /// Whether holdStill() has acted since STOP was engaged.
  bool holding_ = false;
  /// See alwaysSendClasses().
  bool classesAlways_ = false;
  LabeledListener labeledListener_;

  robotlink::Sender<foxglove::RawImage> image_;
  robotlink::Sender<foxglove::RawImage> classes_;
  CameraSettingsSender settings_;
  robotlink::Sender<foxglove::JointStates> jointStates_;
  robotlink::Sender<robotcontrol::BodySensors> bodySensors_;
  robotlink::Sender<robotcontrol::RobotState> trueState_;
  robotlink::Receiver<robotcontrol::JointRequest> jointRequest_;
  /// Only if there is a port for it: the index of the guide.
  std::optional<robotlink::Receiver<robotcontrol::MotionStatus>> motionStatus_;
  std::size_t walk_ = 0;
};

}  // namespace app
