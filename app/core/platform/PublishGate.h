// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "robotlink/session/StreamMessage.h"

namespace logplayer {
class Recorder;
}
namespace robotcontrol {
class HostingStatus;
}
namespace robotlink {
class Process;
class Session;
struct GroundMap;
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

/// Returns a message for a robot's log. `source` is the name that users see beside the text, `level` a
/// foxglove::Log::Level.
robotlink::StreamMessage textMessage(const std::string& robot, const std::string& source,
                                     robotlink::Instant time, int level, const std::string& text);

/// The gate through which a run publishes to the session. While it is closed, as at first, it keeps messages
/// back: a run publishes while it is being made, when the session still belongs to another run, which
/// continues if that fails.
///
/// A replay also passes its messages to a recorder here; it begins a new file whenever the gate is opened
/// with messages kept back, since these are from another place in the log. (A simulation taps the run
/// itself, at full rate: RecordingTap.)
///
/// Any thread. Session and recorder must outlive it.
class PublishGate {
 public:
  /// `recorder` may be null: nothing is recorded here.
  explicit PublishGate(robotlink::Session& session, logplayer::Recorder* recorder = nullptr)
      : session_(session), recorder_(recorder) {}

  /// Publishes what was kept back, in order, and from now on everything at once.
  void open();
  /// Keeps back what is published from now on.
  void close();
  /// Drops what is kept back.
  void discard();
  /// Whether the published messages have readers. Otherwise queues in which frames only end are dropped.
  void setRead(bool isRead) { isRead_ = isRead; }

  /// Publishes one message.
  void publish(robotlink::StreamMessage message);
  /// Publishes messages that the session keeps or drops as a whole.
  void publishFrame(std::vector<robotlink::StreamMessage> frame);
  /// Publishes the contents of a debug queue.
  void publishQueue(const std::string& robot, std::shared_ptr<const robotlink::SharedDebugQueue> queue);
  /// Publishes an error in the robot's log.
  void publishError(const std::string& robot, const std::string& source, robotlink::Instant time,
                    const std::string& text);
  /// Publishes a text in the robot's log; see textMessage().
  void publishText(const std::string& robot, const std::string& source, robotlink::Instant time, int level,
                   const std::string& text);
  /// Publishes the notes of the robot's map in its log: as warnings if the map was read incompletely,
  /// otherwise as information.
  void publishMapNotes(const std::string& robot, robotlink::Instant time, const robotlink::GroundMap& map);
  /// Publishes a sentence about a robot's platform in the robot's log, or keeps it for keptReports().
  void publishPlatform(const std::string& robot, robotlink::Instant time, const std::string& text);
  /// The same about what does not work, as a warning.
  void publishPlatformProblem(const std::string& robot, robotlink::Instant time, const std::string& text);
  /// Call this before the run ends: what the platforms report from now on is kept, since the session will
  /// belong to another run.
  void keepReports();
  /// The kept reports, as a sentence each. After the run has ended.
  std::vector<std::string> keptReports() const { return *reports_; }
  /// Publishes where a robot's program runs, and in the robot's log what happened to it.
  void publishHosting(const std::string& robot, robotlink::Instant time,
                      const robotcontrol::HostingStatus& status);
  /// Publishes a problem of a process as an error in the robot's log, at the time of the process.
  void publishTrouble(const std::string& robot, const robotlink::Process& process, const std::string& text);

 private:
  void publishPlatformText(const std::string& robot, robotlink::Instant time, int level,
                           const std::string& text);
  /// Calls `push`, now or when the gate is opened.
  void pass(std::function<void()> push);
  /// Adds a frame to the recorder, if there is one.
  void record(std::vector<robotlink::StreamMessage> frame);
  /// Adds the frames of a debug queue to the recorder while that is active.
  void recordQueue(const std::string& robot, const std::shared_ptr<const robotlink::SharedDebugQueue>& queue);

  robotlink::Session& session_;
  /// Null if nothing is recorded here.
  logplayer::Recorder* recorder_;
  /// Protects open_ and kept_.
  std::mutex mutex_;
  bool open_ = false;
  std::atomic<bool> isRead_{true};
  /// The calls that open() will make.
  std::vector<std::function<void()>> kept_;
  /// Null before keepReports().
  std::unique_ptr<std::vector<std::string>> reports_;
};

}  // namespace app
