// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/FrameMessages.h"

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"

namespace logplayer::bhuman {

using robotlink::assign;
using robotlink::Instant;
using robotlink::StreamMessage;

namespace {

/// Creates a message with an empty package of a type.
template <typename Type>
std::shared_ptr<Type> packageAt(Instant time) {
  auto package = std::make_shared<Type>();
  assign(*package->mutable_timestamp(), time);
  return package;
}

StreamMessage message(std::string path, robotlink::PackagePtr value) {
  return {std::move(path), {}, std::move(value)};
}

}  // namespace

StreamMessage cameraImage(const robotlink::Image& image, const std::string& frame, Instant time) {
  auto package = std::make_shared<foxglove::RawImage>();
  assign(*package, image.view(), time, frame);
  return message(robotlink::kCameraImage.name, std::move(package));
}

StreamMessage cameraPose(const CameraPlace& place, const CameraOptics& optics, Instant time) {
  auto package = packageAt<robotcontrol::CameraPose>(time);
  assign(*package->mutable_camera_in_robot(), place.cameraInRobot);
  package->set_horizontal_angle(optics.horizontalAngle);
  package->set_vertical_angle(optics.verticalAngle);
  package->set_width(static_cast<std::uint32_t>(optics.width));
  package->set_height(static_cast<std::uint32_t>(optics.height));
  package->set_uncertain(!place.valid);
  return message(robotlink::kCameraPose.name, std::move(package));
}

StreamMessage jointStates(const JointAngles& joints, Instant time) {
  auto package = packageAt<foxglove::JointStates>(time);
  for (std::size_t i = 0; i < kJointCount; ++i) {
    foxglove::JointState& joint = *package->add_joints();
    joint.set_name(std::string(kJointNames[i]));
    if (joints.angles[i]) joint.set_position(*joints.angles[i]);
  }
  return message(robotlink::kJointStates.name, std::move(package));
}

StreamMessage bodySensors(const SensorReadings& sensors, Instant time) {
  auto package = packageAt<robotcontrol::BodySensors>(time);
  if (sensors.acceleration) assign(*package->mutable_acceleration(), *sensors.acceleration);
  return message(robotlink::kBodySensors.name, std::move(package));
}

StreamMessage bodyReadings(const std::vector<Reading>& readings, Instant time) {
  auto package = packageAt<robotcontrol::BodyReadings>(time);
  for (const Reading& each : readings) {
    auto& reading = *package->add_readings();
    reading.set_name(each.name);
    reading.set_value(each.value);
    reading.set_unit(each.unit);
  }
  return message(robotlink::kBodyReadings.name, std::move(package));
}

StreamMessage motionStatus(const robotlink::Pose2& odometry, Instant time) {
  auto package = packageAt<robotcontrol::MotionStatus>(time);
  assign(*package->mutable_odometry(), odometry);
  return message(robotlink::kMotionStatus.name, std::move(package));
}

StreamMessage text(const std::string& text, Level level, const std::string& name, Instant time) {
  auto package = packageAt<foxglove::Log>(time);
  package->set_level(level == Level::kWarning ? foxglove::Log::WARNING : foxglove::Log::INFO);
  package->set_message(robotlink::validUtf8(text));
  package->set_name(name);
  return message(robotlink::streams::kLog, std::move(package));
}

StreamMessage frameInfo(const std::string& process, std::uint64_t number, Instant time) {
  auto package = packageAt<robotcontrol::FrameInfo>(time);
  package->set_process(process);
  package->set_number(number);
  return message(robotlink::streams::kFrames + process, std::move(package));
}

}  // namespace logplayer::bhuman
