// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/PackageTypes.h"

#include "foxglove/Grid.pb.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Ranging.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Accessories.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/MapPackages.h"
#include "robotlink/packages/Packages.h"

namespace robotlink {
namespace {

using google::protobuf::Descriptor;
using Types = std::map<std::string, const Descriptor*>;

template <typename... T>
Types typesOf(const Package<T>&... packages) {
  return {{packages.name, T::descriptor()}...};
}

}  // namespace

const Types& ownPackageTypes() {
  static const Types kTypes = typesOf(
      kCameraImage, kCameraSettings, kJointStates, kBodySensors, kBodyReadings, kOracleWorld, kOracleClasses,
      kDriveState, kSonar, kLaser, kLinkStatus, kLinkPackets, kJointRequest, kDriveRequest, kRemoteMotion,
      kColorTable, kMotionTexts, kDriveGoal, kCameraPose, kColorRegions, kBallPercept, kLandmarkPercepts,
      kRobotPercepts, kBallModel, kRobotPose, kPlayersModel, kMotionRequest, kHeadMode, kHeadRequest,
      kMotionStatus, kDrivePath, kBehaviorDrive, kBehaviorState, kGridMap, kGripper, kGameState, kTeamMessage,
      kTeamMessages, kFieldLines, kRobotState, kOracleState, kTeamBall, kBehaviorGraph);
  return kTypes;
}

const Descriptor* typeOfPackage(const std::string& package) {
  if (package.starts_with("debug/queue/")) return robotcontrol::DebugQueue::descriptor();
  if (package.starts_with("debug/requests/")) return robotcontrol::RequestQueue::descriptor();
  if (package.starts_with("debug/processes/")) return robotcontrol::ProcessTable::descriptor();
  const auto found = ownPackageTypes().find(package);
  return found == ownPackageTypes().end() ? nullptr : found->second;
}

}  // namespace robotlink
