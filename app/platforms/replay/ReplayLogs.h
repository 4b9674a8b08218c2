// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/platforms/replay/ReplayOptions.h"
#include "app/platforms/replay/ReplayRobot.h"
#include "app/platforms/replay/ReplaySource.h"
#include "robotlink/base/Clock.h"

namespace app {

/// The logs of a replay on their common timeline, with their robots: finds instants, robots, streams and
/// frames. Instants are those of the timeline unless they are called log times; a source and its robots work
/// with the times of their log. One thread.
class ReplayLogs {
 public:
  /// A log with its robots.
  struct Source {
    /// Owned by the options of the replay.
    const ReplayLog& log;
    ReplaySource reader;
    /// Whether it publishes streams that belong to no robot. Once a log has a scene, those after it do not.
    bool publishesWorld = true;
    std::vector<std::unique_ptr<ReplayRobot>> robots = {};
    /// The same robots by their names in the log.
    std::map<std::string, ReplayRobot*> byLogName = {};

    /// Converts an instant of the timeline to one of the log.
    robotlink::Instant inLog(robotlink::Instant time) const { return time - log.offset; }
    /// Converts an instant of the log to one of the timeline.
    robotlink::Instant onLine(robotlink::Instant time) const { return time + log.offset; }
  };

  /// Adds a log, without its robots. `log` must outlive this object.
  Source& add(const ReplayLog& log, std::shared_ptr<logplayer::LogFile> file);
  const std::vector<std::unique_ptr<Source>>& sources() const { return sources_; }

  /// The first and the last instant of all logs.
  robotlink::Instant begin() const;
  robotlink::Instant end() const;
  /// The next instant at which a source has something to read; nothing at the end.
  std::optional<robotlink::Instant> nextTime() const;

  /// All robots, in the order of the logs.
  std::vector<ReplayRobot*> robots() const;
  /// Finds a robot by its name in the replay; null if there is none.
  ReplayRobot* find(const std::string& robot) const;
  /// A name for one more robot: its own, or with a number if that is taken.
  std::string freeName(const std::string& robot) const;
  /// The process to be stepped, "<robot>/<process>": preferably one of the first robot that waits for images.
  std::string stepProcess() const;

  /// The time of the first message of a stream; nothing if there is no such stream.
  std::optional<robotlink::Instant> firstTime(const std::string& stream) const;
  /// The time of the instant `count` instants of a stream after (negative: before) `now`.
  std::optional<robotlink::Instant> countedTime(const std::string& stream, int count,
                                                robotlink::Instant now) const;
  /// The time of a frame of "<robot>/<process>" by the number that the process gave it.
  std::optional<robotlink::Instant> timeOfFrame(const std::string& process, std::uint64_t frame) const;
  /// The stream of a process's frames, by "<robot>/<process>"; empty if that is no such name.
  static std::string framesOf(const std::string& process);

  /// Fills in logs, processes, packages, differences, tasks, beginning and end.
  void describe(robotcontrol::ReplayStatus& status) const;
  /// Fills in which frame of a process is shown at an instant.
  void describeFrame(const std::string& process, robotlink::Instant now,
                     robotcontrol::ReplayStatus& status) const;

 private:
  /// The position of a stream of the replay in the logs; the source is null if there is no such stream.
  struct Place {
    Source* source = nullptr;
    /// Its path in the log.
    std::string stream;
  };
  /// Finds a stream by its path in the replay.
  Place placeOf(const std::string& stream) const;
  void describeLogs(robotcontrol::ReplayStatus& status) const;
  void describePackages(robotcontrol::ReplayStatus& status) const;

  std::vector<std::unique_ptr<Source>> sources_;
};

}  // namespace app
