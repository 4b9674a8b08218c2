// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/PackageTitles.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/MapPackages.h"
#include "robotlink/packages/Packages.h"

namespace robotlink {
namespace {

struct Title {
  std::string_view package, text;
};
constexpr std::array kTitles{
    Title{kCameraImage.name, "camera images"},
    Title{kCameraSettings.name, "settings of the camera"},
    Title{kJointStates.name, "joint angles"},
    Title{kBodySensors.name, "the body's sensors"},
    Title{kBodyReadings.name, "the body's readings"},
    Title{kOracleWorld.name, "the simulator's ground truth"},
    Title{kOracleState.name, "the simulator's true state of the body"},
    Title{kOracleClasses.name, "the simulator's true color classes"},
    Title{kDriveState.name, "the state of a base on wheels"},
    Title{kSonar.name, "sonar readings"},
    Title{kLaser.name, "laser scans"},
    Title{kLinkStatus.name, "the state of the connection"},
    Title{kLinkPackets.name, "the connection's packets"},
    Title{kJointRequest.name, "requests to joints"},
    Title{kDriveRequest.name, "requests to wheels"},
    Title{kRemoteMotion.name, "motions that the user requests"},
    Title{kColorTable.name, "a color table"},
    Title{kMotionTexts.name, "key-frame motions"},
    Title{kDriveGoal.name, "a goal that the user sets"},
    Title{kCameraPose.name, "the camera's pose"},
    Title{kColorRegions.name, "colored regions"},
    Title{kBallPercept.name, "ball percepts"},
    Title{kLandmarkPercepts.name, "landmark percepts"},
    Title{kRobotPercepts.name, "robot percepts"},
    Title{kBallModel.name, "the ball model"},
    Title{kRobotPose.name, "the robot's pose"},
    Title{kPlayersModel.name, "the players model"},
    Title{kMotionRequest.name, "motion requests"},
    Title{kHeadMode.name, "the head's mode"},
    Title{kHeadRequest.name, "head requests"},
    Title{kMotionStatus.name, "the state of motion"},
    Title{kDrivePath.name, "a path"},
    Title{kBehaviorDrive.name, "the behavior's drive requests"},
    Title{kBehaviorState.name, "the behavior's state"},
    Title{kGridMap.name, "the map that it made"},
    Title{kGripper.name, "the state of a gripper"},
    Title{kGameState.name, "the state of the game"},
    Title{kTeamMessage.name, "what it sends to its team"},
    Title{kTeamMessages.name, "what it receives from its team"},
    Title{kFieldLines.name, "field lines"},
    Title{kRobotState.name, "the robot's state"},
    Title{kTeamBall.name, "the team's ball"},
    Title{kBehaviorGraph.name, "the behavior's options"},
};

}  // namespace

std::string packageTitle(const std::string& package) {
  const auto known = std::find_if(kTitles.begin(), kTitles.end(),
                                  [&](const Title& title) { return title.package == package; });
  return known == kTitles.end() ? package : std::string(known->text) + " (" + package + ")";
}

std::string notProvided(const std::string& package) {
  return "neither the robot nor another task provides " + packageTitle(package);
}

}  // namespace robotlink
