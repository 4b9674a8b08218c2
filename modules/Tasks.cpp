// SPDX-License-Identifier: GPL-3.0-or-later
// The descriptions of the robot program's tasks. Their solutions register themselves, each next to its class.
#include "robotlink/debugging/Solution.h"

namespace modules {
namespace {

using robotlink::TaskRegistration;

const TaskRegistration kSegmentation("segmentation",
                                     "Finds the areas of the field's colors in the camera's image.");
const TaskRegistration kRobotState(
    "robot-state", "Judges whether the robot was picked up, has fallen, or collided with something.");
const TaskRegistration kCameraPose("camera-pose", "Determines where the camera was when it took the image.");
const TaskRegistration kBallPercept("ball-percept",
                                    "Finds the ball in the image, and its place on the ground.");
const TaskRegistration kLandmarkPercepts("landmark-percepts", "Finds beacons and goals in the image.");
const TaskRegistration kLinePercepts("line-percepts", "Finds the lines of the field in the image.");
const TaskRegistration kRobotPercepts("robot-percepts", "Finds other robots in the image.");
const TaskRegistration kBallModel("ball-model",
                                  "Estimates the ball's position and velocity, even while it is not seen.");
const TaskRegistration kSelfLocalization("self-localisation",
                                         "Estimates where the robot is on the field, or in the building.");
const TaskRegistration kMapping("mapping",
                                "Makes a map of where the robot drives, and finds its place in it.");
const TaskRegistration kPlayersModel("players-model", "Estimates where the other robots are on the field.");
const TaskRegistration kTeamBall("team-ball",
                                 "Estimates the ball's position from what the whole team knows.");
const TaskRegistration kBehavior("behavior", "Decides what the robot does: where it goes, looks and kicks.");
const TaskRegistration kPathPlanning("path-planning", "Plans the path to the goal that the user set.");
const TaskRegistration kDriving("driving", "Decides where a robot on wheels goes.");
const TaskRegistration kObstacleAvoidance("obstacle-avoidance",
                                          "Drives as desired where that is safe, and avoids obstacles.");
const TaskRegistration kHeadControl("head-control", "Turns the head to where the behavior wants it to look.");
const TaskRegistration kMotion("motion", "Moves the joints: stands, walks, kicks and gets up.");

}  // namespace
}  // namespace modules
