// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
class DebugQueue;
}
namespace robotlink {
class Process;
class Session;
struct GroundMap;
}  // namespace robotlink

namespace app {

/// A text in a robot's log. `level`: a foxglove::Log::Level.
robotlink::StreamMessage textMessage(const std::string& robot, const std::string& source,
                                     robotlink::Instant time, int level, const std::string& text);

/// The way of all that a run tells to the session. While it is closed, as at first, it keeps everything back:
/// a run tells things while it is being made, when the session still belongs to another one that goes on if
/// that fails.
///
/// A recorder may be told the same (that of a simulation taps the run itself, at full rate): each time that
/// the outlet is opened with something kept back is another telling, for which it begins a new file.
///
/// Any thread. Session and recorder must outlive it.
class PublishGate {
 public:
  explicit PublishGate(robotlink::Session& session, logplayer::Recorder* recorder = nullptr)
      : session_(session), recorder_(recorder) {}

  void open();
  void close();
  /// Forgets what it keeps back.
  void discard();

  void publish(robotlink::StreamMessage message);
  /// What belongs together.
  void publishFrame(std::vector<robotlink::StreamMessage> frame);
  void publishQueue(const std::string& robot, std::shared_ptr<const robotcontrol::DebugQueue> queue);
  /// In the robot's log.
  void publishError(const std::string& robot, const std::string& source, robotlink::Instant time,
                    const std::string& text);
  /// `level`: a foxglove::Log::Level.
  void publishText(const std::string& robot, const std::string& source, robotlink::Instant time, int level,
                   const std::string& text);
  /// What is to be known about the map that the robot drives by, as texts.
  void publishMapNotes(const std::string& robot, robotlink::Instant time, const robotlink::GroundMap& map);
  /// That something is wrong with a process.
  void publishTrouble(const std::string& robot, const robotlink::Process& process, const std::string& text);

 private:
  void pass(std::function<void()> push);
  void record(std::vector<robotlink::StreamMessage> frame);
  void recordQueue(const std::string& robot, const std::shared_ptr<const robotcontrol::DebugQueue>& queue);

  robotlink::Session& session_;
  logplayer::Recorder* recorder_;  // null: there is none
  std::mutex mutex_;               // protects the following
  bool open_ = false;
  std::vector<std::function<void()>> kept_;
};

}  // namespace app
