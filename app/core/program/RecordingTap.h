// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "logplayer/record/Recorder.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/process/Platform.h"

namespace robotcontrol {
class DebugQueue;
class Request;
}  // namespace robotcontrol
namespace robotlink {
class RobotProgram;
}

namespace app {

/// Hands all that the robots of one run tell to a recorder, in complete frames: debug queues, taken apart;
/// what the platform and the debug process send, tapped at their senders at full rate; requests, when they
/// are handed in; and what the programs are made of. While nothing is recorded it costs one look at a flag
/// for each package, but what holds until told anew is always handed on.
///
/// Made for one run; the recorder must outlive the run's platforms and programs.
class RecordingTap {
 public:
  explicit RecordingTap(logplayer::Recorder& recorder) : recorder_(recorder) {}
  ~RecordingTap();
  RecordingTap(const RecordingTap&) = delete;
  RecordingTap& operator=(const RecordingTap&) = delete;

  // While no process runs.
  /// All programs before are gone.
  void clear() { robots_.clear(); }
  /// The platforms' clocks start anew.
  void restart() { recorder_.restart(); }
  /// A program that has not run yet, on a platform that was not tapped before, or in the place of the one
  /// that ran there. Tells its set-up and has the program tell what is to be recorded from its first frame
  /// on.
  void attach(const std::string& robot, robotlink::Platform& platform, robotlink::RobotProgram& program,
              robotcontrol::ProgramSetup setup);

  // The thread that steps the platforms.
  /// Before a step: asks the programs for what the recorder wants, if that has changed.
  void askForPackages();
  /// After a step: a platform's frame is complete.
  void endStep();
  /// A request that was handed to a robot's program just now.
  void handedIn(const robotcontrol::Request& request);
  /// What belongs to no robot's program: the scene, transforms, the state of the simulation.
  void world(robotlink::StreamMessage message);
  bool wants(const std::string& path) const { return recorder_.wants(path); }

  // The thread of the robot's debug process.
  void add(const std::string& robot, const std::shared_ptr<const robotcontrol::DebugQueue>& queue);

 private:
  struct Robot;
  Robot* find(const std::string& name) const;

  logplayer::Recorder& recorder_;
  std::vector<std::shared_ptr<Robot>> robots_;
  std::uint64_t demand_ = 0;  // of the recorder, that was asked for
};

}  // namespace app
