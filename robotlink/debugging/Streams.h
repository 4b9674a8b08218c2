// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace robotlink::streams {

/// The robot whose stream has a path: "red1" of "red1/camera/image"; empty for streams of the whole world.
inline std::string robotOf(std::string_view path) {
  const std::size_t slash = path.find('/');
  return std::string(slash == std::string_view::npos ? std::string_view() : path.substr(0, slash));
}

// The paths of a robot's messages, below its name: the values of DebugMessage.path. All streams with their
// types and sources are listed in robotlink/session/STREAMS.md. The path of a requested package is its name.

inline constexpr char kLog[] = "log";  ///< foxglove.Log, of all processes
/// foxglove.Log.name of what a robot's platform reports; else it is the process.
inline constexpr char kPlatformSource[] = "platform";
/// foxglove.Log.name of texts about a simulated world that was put to another instant.
inline constexpr char kWorldSource[] = "world";
inline constexpr char kKeys[] = "tables/keys";            ///< KeyTable, of all processes together
inline constexpr char kSolutions[] = "tables/solutions";  ///< SolutionTable
inline constexpr char kProcesses[] = "tables/processes";  ///< ProcessTable
/// ColorTable without its cells and correction: which one is in use, and where it is from.
inline constexpr char kColorTableInUse[] = "tables/colors";
inline constexpr char kMotions[] = "tables/motions";          ///< MotionTable
inline constexpr char kSubscribers[] = "tables/subscribers";  ///< KeySubscribers, of a served session
inline constexpr char kSteering[] = "steering";               ///< SteeringStatus, of a served session
inline constexpr char kResults[] = "results";           ///< RequestResult; passed to the requester, not kept
inline constexpr char kFrames[] = "frames/";            ///< + process: FrameInfo
inline constexpr char kStopwatches[] = "stopwatches/";  ///< + process: StopwatchTimes
inline constexpr char kParameters[] = "parameters/";    ///< + task/solution: ParameterValues
inline constexpr char kImages[] = "images/";            ///< + key: foxglove.RawImage
inline constexpr char kPlots[] = "plots/";              ///< + key or key/curve: PlotValue
inline constexpr char kImageDrawings[] = "drawings/image/";  ///< + key: foxglove.ImageAnnotations
/// + key: foxglove.SceneUpdate in the frame "field"
inline constexpr char kFieldDrawings[] = "drawings/field/";
/// + key: foxglove.SceneUpdate in the robot's frame
inline constexpr char kRobotDrawings[] = "drawings/robot/";
inline constexpr char kProgram[] = "program";    ///< ProgramSetup
inline constexpr char kHosting[] = "hosting";    ///< HostingStatus
inline constexpr char kRequests[] = "requests";  ///< Request, as it was enqueued
/// + package: the logged version of a package that is recomputed from a log
inline constexpr char kLogged[] = "logged/";
/// + solution/ + path: what a solution publishes that runs in the shadow of the active one
inline constexpr char kShadow[] = "shadow/";

// Streams of the whole world, without a robot's name.
inline constexpr char kScene[] = "scene";              ///< foxglove.SceneUpdate
inline constexpr char kSolids[] = "solids";            ///< foxglove.SceneUpdate: what collides
inline constexpr char kTransforms[] = "transforms";    ///< foxglove.FrameTransforms
inline constexpr char kObjects[] = "objects";          ///< WorldObjects
inline constexpr char kPorts[] = "ports";              ///< PortReadings
inline constexpr char kForces[] = "forces";            ///< WorldForces
inline constexpr char kEvents[] = "events";            ///< ViewEvents
inline constexpr char kControllers[] = "controllers";  ///< ControllerStates
/// + name of a remote controller: ControllerInputs
inline constexpr char kControllerInputs[] = "sim/ports/";
inline constexpr char kSimulation[] = "simulation";  ///< SimulationStatus
inline constexpr char kGame[] = "game";              ///< GameStatus
inline constexpr char kRecording[] = "recording";    ///< RecordingStatus
inline constexpr char kReplay[] = "replay";          ///< ReplayStatus
inline constexpr char kMap[] = "map";                ///< GroundMap
inline constexpr char kBookmarks[] = "bookmarks";    ///< foxglove.Event, in log files

}  // namespace robotlink::streams
