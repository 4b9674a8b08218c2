// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/replay/ReplayRobot.h"
#include "app/core/replay/ReplayRun.h"
#include "app/core/replay/ReplaySource.h"

namespace app {

/// The insides of ReplayRun, for its sources alone. What is called a time is one of the time line; a source
/// and its robots know the times of their log.
struct ReplayRun::Implementation {
  struct Source {
    ReplayLog log;
    ReplaySource reader;
    bool publishesWorld = true;  ///< what belongs to no robot: of the first log that has it
    std::vector<std::unique_ptr<ReplayRobot>> robots;
    std::map<std::string, ReplayRobot*> byLogName;

    robotlink::Instant inLog(robotlink::Instant time) const { return time - log.offset; }
    robotlink::Instant onLine(robotlink::Instant time) const { return time + log.offset; }
  };
  /// A stream of a log, by what it is called in the replay.
  struct Place {
    Source* source = nullptr;
    ReplayRobot* robot = nullptr;
    std::string stream;  ///< in the log
  };

  // Making it.
  robotlink::Errors open();
  robotlink::Duration offsetOf(const ReplayLog& log, const logplayer::LogFile& file) const;
  robotlink::Errors addRobots(Source& source);
  robotlink::Errors checkChosenSolutions() const;
  std::string freeName(const std::string& robot) const;
  void findStepProcess();

  // Going on.
  bool step();
  robotlink::Errors jump(robotlink::Instant time);
  robotlink::Errors jump(Source& source, robotlink::Instant time);
  std::string firstRobot() const;
  void runQuietly(Source& source, robotlink::Instant from, robotlink::Instant to);
  void give(Source& source, robotlink::Instant logTime,
            const std::vector<robotlink::StreamMessage>& messages);
  void publish(Source& source, const std::vector<robotlink::StreamMessage>& messages);
  std::optional<robotlink::StreamMessage> published(Source& source,
                                                    const robotlink::StreamMessage& message) const;
  void hear(const Source& source, const std::string& robot,
            const std::shared_ptr<const robotcontrol::DebugQueue>& queue);
  void note(const Source& source, const std::string& robot, robotlink::Instant logTime, int level,
            const std::string& text);
  robotlink::Errors changeChoices(
      const std::function<void(const std::string& robot, ReplayChoices&)>& change);

  // Finding.
  std::optional<robotlink::Instant> nextTime() const;
  ReplayRobot* findRobot(const std::string& name) const;
  Place placeOf(const std::string& stream) const;
  std::optional<robotlink::Instant> countedTime(const std::string& stream, int count) const;
  std::optional<robotlink::Instant> timeOfFrame(const std::string& process, std::uint64_t frame) const;
  static std::string framesOf(const std::string& process);
  void describeLogs(robotcontrol::ReplayStatus& status) const;
  void describePackages(robotcontrol::ReplayStatus& status) const;
  void describeFrame(robotcontrol::ReplayStatus& status) const;

  ReplayOptions options;
  Listeners listeners;
  std::vector<std::unique_ptr<Source>> sources;
  std::shared_ptr<const robotcontrol::ColorTable> colorTable;
  robotlink::Instant now;
  std::string stepProcess;

  // During a jump nobody listens: what programs tell, of streams without a history only the newest, is told
  // at its end, and answers.
  bool quiet = false;
  std::vector<robotlink::StreamMessage> history;
  std::map<std::string, robotlink::StreamMessage> newest;
  std::shared_ptr<robotcontrol::DebugQueue> answers;
  std::vector<robotlink::StreamMessage> notes;
};

}  // namespace app
