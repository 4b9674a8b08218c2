// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foxglove {
class JointStates;
class LaserScan;
class RawImage;
}  // namespace foxglove

namespace robotcontrol {
class BallModel;
class BallPercept;
class BodyReadings;
class BodySensors;
class CameraPose;
class ColorRegions;
class ColorTable;
class DriveGoal;
class DrivePath;
class DriveRequest;
class DriveState;
class HeadMode;
class HeadRequest;
class JointRequest;
class LandmarkPercepts;
class LinkPackets;
class LinkStatus;
class MotionRequest;
class MotionStatus;
class OracleWorld;
class PlayersModel;
class RemoteMotion;
class RobotPercepts;
class RobotPose;
class SonarReadings;
}  // namespace robotcontrol

namespace robotlink {

/// The name of a package with its type. A package's stream in the workbench is robot + "/" + name.
template <typename T>
struct Package {
  const char* name;
};

// What a robot's platform offers...
inline constexpr Package<foxglove::RawImage> kCameraImage{"camera/image"};
inline constexpr Package<foxglove::JointStates> kJointStates{"joints/states"};
inline constexpr Package<robotcontrol::BodySensors> kBodySensors{"body/sensors"};
inline constexpr Package<robotcontrol::BodyReadings> kBodyReadings{"body/readings"};
inline constexpr Package<robotcontrol::OracleWorld> kOracleWorld{"oracle/world"};
/// What each pixel of camera/image truly shows: mono8, on request only; numbers as in STREAMS.md.
inline constexpr Package<foxglove::RawImage> kOracleClasses{"oracle/classes"};
inline constexpr Package<robotcontrol::DriveState> kDriveState{"drive/state"};
inline constexpr Package<robotcontrol::SonarReadings> kSonar{"range/sonar"};
inline constexpr Package<foxglove::LaserScan> kLaser{"range/laser"};
/// How the line to the robot does, and on request what goes over it.
inline constexpr Package<robotcontrol::LinkStatus> kLinkStatus{"link/status"};
inline constexpr Package<robotcontrol::LinkPackets> kLinkPackets{"link/packets"};
// ...and takes.
inline constexpr Package<robotcontrol::JointRequest> kJointRequest{"joints/request"};
inline constexpr Package<robotcontrol::DriveRequest> kDriveRequest{"drive/request"};

// What the debug process offers: a person's wishes.
inline constexpr Package<robotcontrol::RemoteMotion> kRemoteMotion{"remote/motion"};
inline constexpr Package<robotcontrol::ColorTable> kColorTable{"colors/table"};
inline constexpr Package<robotcontrol::DriveGoal> kDriveGoal{"remote/goal"};

// What the tasks of the robot program exchange.
inline constexpr Package<robotcontrol::CameraPose> kCameraPose{"camera/pose"};
inline constexpr Package<robotcontrol::ColorRegions> kColorRegions{"percepts/regions"};
inline constexpr Package<robotcontrol::BallPercept> kBallPercept{"percepts/ball"};
inline constexpr Package<robotcontrol::LandmarkPercepts> kLandmarkPercepts{"percepts/landmarks"};
inline constexpr Package<robotcontrol::RobotPercepts> kRobotPercepts{"percepts/robots"};
inline constexpr Package<robotcontrol::BallModel> kBallModel{"models/ball"};
inline constexpr Package<robotcontrol::RobotPose> kRobotPose{"models/pose"};
inline constexpr Package<robotcontrol::PlayersModel> kPlayersModel{"models/players"};
inline constexpr Package<robotcontrol::MotionRequest> kMotionRequest{"behavior/motion"};
inline constexpr Package<robotcontrol::HeadMode> kHeadMode{"behavior/head"};
inline constexpr Package<robotcontrol::HeadRequest> kHeadRequest{"motion/head"};
inline constexpr Package<robotcontrol::MotionStatus> kMotionStatus{"motion/status"};
inline constexpr Package<robotcontrol::DrivePath> kDrivePath{"models/path"};
/// What the behaviour of a robot on wheels would like, before obstacles are avoided.
inline constexpr Package<robotcontrol::DriveRequest> kDriveWish{"behavior/drive"};

}  // namespace robotlink
