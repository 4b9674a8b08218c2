// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "logplayer/record/Recorder.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/process/Platform.h"

namespace robotcontrol {
class Request;
}  // namespace robotcontrol
namespace robotlink {
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

class HostedProgram;

/// Passes everything that a log may contain from the robots of one run to a recorder, in complete frames: the
/// messages of debug queues; the packages of the platform and of the debug process, tapped at their senders
/// at full rate; requests, which it passes to the programs; and the setups of the programs. While nothing is
/// recorded, this costs one look at a flag for each package; only latched messages are still passed on.
///
/// One object for one run. The recorder must outlive the platforms and programs of the run.
class RecordingTap {
 public:
  explicit RecordingTap(logplayer::Recorder& recorder) : recorder_(recorder) {}
  ~RecordingTap();
  RecordingTap(const RecordingTap&) = delete;
  RecordingTap& operator=(const RecordingTap&) = delete;

  // Only while no process runs:
  /// Forgets all robots. Call this when their programs have ended.
  void clear() { robots_.clear(); }
  /// Forgets a robot whose program has ended or gets another platform; does nothing if there is none.
  void detach(const std::string& robot);
  /// Call this when the platforms' clocks restart.
  void restart() { recorder_.restart(); }
  /// Attaches the program of a robot before it runs. A robot that is attached already must have the same
  /// platform; the new program then replaces the previous one. Records the setup, and lets the program
  /// publish the packages that the recorder wants from its first frame on.
  void attach(const std::string& robot, robotlink::Platform& platform, HostedProgram& program,
              robotcontrol::ProgramSetup setup);

  // Only in the thread that steps the platforms:
  /// Before a step: requests the packages that the recorder wants, if that has changed.
  void askForPackages();
  /// Call this after a step: records what the platforms have sent in it as one frame each.
  void endStep();
  /// Passes a request to the program of a robot, and records it. If it asks for packages, those that the
  /// recorder wants are added. Returns false if the program takes no requests now.
  bool request(const std::string& robot, const robotcontrol::Request& request);
  /// Records a message that belongs to no robot's program: the scene, transforms, the state of the
  /// simulation.
  void world(robotlink::StreamMessage message);
  /// Whether the recorder wants a stream, so that others need not be made.
  bool wants(const std::string& path) const { return recorder_.wants(path); }

  // Only in the thread of the robot's debug process:
  /// Records a debug queue of a robot, and the setup again if solutions or parameters have changed.
  void add(const std::string& robot, const std::shared_ptr<const robotlink::SharedDebugQueue>& queue);

 private:
  /// An attached program with the frames that are being collected.
  struct Robot;
  /// Returns null if no such robot is attached.
  Robot* find(const std::string& name) const;

  logplayer::Recorder& recorder_;
  std::vector<std::shared_ptr<Robot>> robots_;
  /// The Recorder::demand() for which packages were last requested.
  std::uint64_t demand_ = 0;
};

}  // namespace app
