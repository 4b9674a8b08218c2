// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/MessageKinds.h"

#include <array>

namespace logplayer::bhuman {
namespace {

/// Indexed by id. The first 23 are data for logs; the others belong to team communication and debugging.
constexpr std::array kNames = {"undefined",
                               "ProcessBegin",
                               "ProcessFinished",
                               "Image",
                               "JPEGImage",
                               "JointData",
                               "SensorData",
                               "KeyStates",
                               "OdometryData",
                               "FrameInfo",
                               "FilteredJointData",
                               "LinePercept",
                               "GoalPercept",
                               "BallPercept",
                               "GroundTruthBallModel",
                               "GroundTruthRobotPose",
                               "ExtendedBallPercepts",
                               "CameraMatrix",
                               "ImageCoordinateSystem",
                               "BoardInfo",
                               "RobotPose",
                               "BallModel",
                               "FilteredSensorData",
                               "ReceiveTimeStamp",
                               "SendTimeStamp",
                               "Robot",
                               "NTPRequest",
                               "NTPResponse",
                               "ReleaseOptions",
                               "Stopwatch",
                               "TeamMateBallModel",
                               "TeamMateRobotPose",
                               "TeamMateBehaviorData",
                               "RobotHealth",
                               "MotionRequest",
                               "TeamMateGoalPercept",
                               "Text",
                               "DebugRequest",
                               "DebugResponse",
                               "DebugDataResponse",
                               "DebugDataChangeRequest",
                               "StreamSpecification",
                               "ModuleTable",
                               "ModuleRequest",
                               "QueueFillRequest",
                               "LogResponse",
                               "DrawingManager",
                               "DrawingManager3D",
                               "DebugImage",
                               "DebugJPEGImage",
                               "DebugGrayScaleImage",
                               "DebugColorClassImage",
                               "DebugDrawing",
                               "DebugDrawing3D",
                               "ColorTable64",
                               "WriteColorTable64",
                               "XabslDebugRequest",
                               "XabslDebugMessage",
                               "XabslDebugSymbols",
                               "XabslIntermediateCode",
                               "MotionNet",
                               "JointRequest",
                               "LEDRequest",
                               "Plot",
                               "Console",
                               "Robotname",
                               "RobotDimensions",
                               "JointCalibration"};
static_assert(kNames.size() == 68);

}  // namespace

bool hasName(std::uint8_t id) {
  return id > 0 && id < kNames.size();
}

std::string kindName(std::uint8_t id) {
  return hasName(id) ? kNames[id] : "id " + std::to_string(id);
}

std::optional<std::uint32_t> fixedSize(std::uint8_t id) {
  switch (static_cast<Kind>(id)) {
    case Kind::kProcessBegin:
    case Kind::kProcessFinished:
      return 1;
    case Kind::kJointData:
      return 180;
    case Kind::kSensorData:
      return 146;
    case Kind::kKeyStates:
      return 20;
    case Kind::kOdometryData:
      return 24;
    case Kind::kCameraMatrix:
      return 100;
    case Kind::kImageCoordinateSystem:
      return 160;
    default:
      return std::nullopt;
  }
}

}  // namespace logplayer::bhuman
