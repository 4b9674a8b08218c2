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
class BehaviorState;
class BodyReadings;
class BodySensors;
class CameraPose;
class CameraSettings;
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
class MotionTexts;
class OracleWorld;
class PlayersModel;
class RemoteMotion;
class RobotPercepts;
class RobotPose;
class SonarReadings;
}  // namespace robotcontrol

namespace robotlink {

/// The name of a package together with its message type, so that senders and receivers of a package agree at
/// compile time. The package's stream in the workbench is robot + "/" + name.
template <typename T>
struct Package {
  const char* name;
};

// Packages that a robot's platform sends.
/// Images of the robot's camera, in one of the encodings of PixelFormat.
inline constexpr Package<foxglove::RawImage> kCameraImage{"camera/image"};
/// Settings of the camera that can be changed, such as its exposure, sent only on request.
inline constexpr Package<robotcontrol::CameraSettings> kCameraSettings{"camera/settings"};
/// Joint angles in rad, each with the name of its joint.
inline constexpr Package<foxglove::JointStates> kJointStates{"joints/states"};
/// Acceleration, distance and paw contacts of a legged robot.
inline constexpr Package<robotcontrol::BodySensors> kBodySensors{"body/sensors"};
/// Further readings of the body, each with a name and a unit, such as the battery's level.
inline constexpr Package<robotcontrol::BodyReadings> kBodyReadings{"body/readings"};
/// Ground truth of the simulator: robots, ball and other objects in the field frame.
inline constexpr Package<robotcontrol::OracleWorld> kOracleWorld{"oracle/world"};
/// The true color class of each pixel of camera/image: mono8, sent only on request; the numbers are listed in
/// STREAMS.md.
inline constexpr Package<foxglove::RawImage> kOracleClasses{"oracle/classes"};
/// Odometry, speed and state of a robot on wheels.
inline constexpr Package<robotcontrol::DriveState> kDriveState{"drive/state"};
/// Ranges of the sonars measured since the last package, m.
inline constexpr Package<robotcontrol::SonarReadings> kSonar{"range/sonar"};
/// A scan of the laser range finder.
inline constexpr Package<foxglove::LaserScan> kLaser{"range/laser"};
/// The state of the connection to the robot; link/packets holds its decoded packets, sent only on request.
inline constexpr Package<robotcontrol::LinkStatus> kLinkStatus{"link/status"};
inline constexpr Package<robotcontrol::LinkPackets> kLinkPackets{"link/packets"};
// Packages that a robot's platform receives.
/// Angles, in rad, and stiffness for the servos.
inline constexpr Package<robotcontrol::JointRequest> kJointRequest{"joints/request"};
/// Speeds for the motors, after obstacle avoidance.
inline constexpr Package<robotcontrol::DriveRequest> kDriveRequest{"drive/request"};

// Packages that the debug process sends on behalf of the user.
/// A motion that the user requests by manual control.
inline constexpr Package<robotcontrol::RemoteMotion> kRemoteMotion{"remote/motion"};
/// A color table that the user has sent; empty cells remove it.
inline constexpr Package<robotcontrol::ColorTable> kColorTable{"colors/table"};
/// The motions that the user has sent; those that were taken back are missing.
inline constexpr Package<robotcontrol::MotionTexts> kMotionTexts{"motions/texts"};
/// A pose in the field that the user wants the robot to reach.
inline constexpr Package<robotcontrol::DriveGoal> kDriveGoal{"remote/goal"};

// Packages that tasks of the robot program exchange.
/// Pose and fields of view of the camera, computed from the joints.
inline constexpr Package<robotcontrol::CameraPose> kCameraPose{"camera/pose"};
/// Regions of color classes in an image.
inline constexpr Package<robotcontrol::ColorRegions> kColorRegions{"percepts/regions"};
/// Position of the ball as seen in one image.
inline constexpr Package<robotcontrol::BallPercept> kBallPercept{"percepts/ball"};
/// Landmarks (beacons, goals) seen in one image.
inline constexpr Package<robotcontrol::LandmarkPercepts> kLandmarkPercepts{"percepts/landmarks"};
/// Other robots seen in one image.
inline constexpr Package<robotcontrol::RobotPercepts> kRobotPercepts{"percepts/robots"};
/// Filtered position and velocity of the ball.
inline constexpr Package<robotcontrol::BallModel> kBallModel{"models/ball"};
/// The estimate of the robot's own pose in the field.
inline constexpr Package<robotcontrol::RobotPose> kRobotPose{"models/pose"};
/// Tracked positions of the other robots.
inline constexpr Package<robotcontrol::PlayersModel> kPlayersModel{"models/players"};
/// The requested gait, speed or special motion of a legged robot.
inline constexpr Package<robotcontrol::MotionRequest> kMotionRequest{"behavior/motion"};
/// The requested target of the head.
inline constexpr Package<robotcontrol::HeadMode> kHeadMode{"behavior/head"};
/// Angles for the joints of the head.
inline constexpr Package<robotcontrol::HeadRequest> kHeadRequest{"motion/head"};
/// The motion that is being executed, and the odometry.
inline constexpr Package<robotcontrol::MotionStatus> kMotionStatus{"motion/status"};
/// The path to the goal that was planned.
inline constexpr Package<robotcontrol::DrivePath> kDrivePath{"models/path"};
/// The speeds that the behavior of a robot on wheels requests, before obstacle avoidance.
inline constexpr Package<robotcontrol::DriveRequest> kBehaviorDrive{"behavior/drive"};
/// The state of the behavior, and since when it lasts.
inline constexpr Package<robotcontrol::BehaviorState> kBehaviorState{"behavior/state"};

}  // namespace robotlink
