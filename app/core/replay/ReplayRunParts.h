// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/replay/ReplayRobot.h"
#include "app/core/replay/ReplayRun.h"
#include "app/core/replay/ReplaySource.h"
#include "robotlink/debugging/SharedDebugQueue.h"

namespace app {

/// The internals of ReplayRun, for its sources only. Instants are those of the time line unless they are
/// called log times; a source and its robots work with the times of their log.
struct ReplayRun::Implementation {
  /// A log with its robots.
  struct Source {
    ReplayLog log;
    ReplaySource reader;
    /// Whether it publishes streams that belong to no robot. Once a log has a scene, those after it do not.
    bool publishesWorld = true;
    std::vector<std::unique_ptr<ReplayRobot>> robots;
    /// The same robots by their names in the log.
    std::map<std::string, ReplayRobot*> byLogName;

    /// Converts an instant of the time line to one of the log.
    robotlink::Instant inLog(robotlink::Instant time) const { return time - log.offset; }
    /// Converts an instant of the log to one of the time line.
    robotlink::Instant onLine(robotlink::Instant time) const { return time + log.offset; }
  };
  /// Where a stream of the replay is in the logs; the source is null if there is no such stream.
  struct Place {
    Source* source = nullptr;
    ReplayRobot* robot = nullptr;
    /// Its path in the log.
    std::string stream;
  };

  // Making it.
  /// Opens all logs and makes their robots.
  robotlink::Errors open();
  /// The offset of a log that is opened after those in `sources`.
  robotlink::Duration offsetOf(const ReplayLog& log, const logplayer::LogFile& file) const;
  /// Makes the robots of a log and starts their programs at its beginning.
  robotlink::Errors addRobots(Source& source);
  /// Checks the solutions of the options. A comparison with another solution than the requested one would be
  /// wrong.
  robotlink::Errors checkChosenSolutions() const;
  /// The name of a robot in the replay: its own, or with a number if that is taken.
  std::string freeName(const std::string& robot) const;
  /// Chooses the step process, preferably one of the first robot that waits for images.
  void findStepProcess();

  // Moving.
  /// See ReplayRun::step().
  bool step();
  /// See ReplayRun::jump().
  robotlink::Errors jump(robotlink::Instant time);
  /// Restarts the programs of a log, and runs them up to the aim.
  robotlink::Errors jump(Source& source, robotlink::Instant time);
  /// The name under which results are published; empty without robots.
  std::string firstRobot() const;
  /// Runs the programs over a range of log times while `quiet` is set. Only the last instant counts for
  /// differences.
  void runQuietly(Source& source, robotlink::Instant from, robotlink::Instant to);
  /// Passes the messages of an instant to the robots of a log. All of them advance to it.
  void give(Source& source, robotlink::Instant logTime,
            const std::vector<robotlink::StreamMessage>& messages);
  /// Publishes the messages of an instant, after waiting notes.
  void publish(Source& source, const std::vector<robotlink::StreamMessage>& messages);
  /// Returns a message of a log as it is published; nothing if it is not.
  std::optional<robotlink::StreamMessage> published(Source& source,
                                                    const robotlink::StreamMessage& message) const;
  /// Publishes a debug queue, or collects its messages during a jump.
  void hear(const Source& source, const std::string& robot,
            const std::shared_ptr<const robotlink::SharedDebugQueue>& queue);
  /// Adds a text to `notes`. `level` is a foxglove::Log::Level.
  void note(const Source& source, const std::string& robot, robotlink::Instant logTime, int level,
            const std::string& text);
  /// Changes the choices of all robots and restarts their programs. If one of them cannot be made, all
  /// choices are restored.
  robotlink::Errors changeChoices(
      const std::function<void(const std::string& robot, ReplayChoices&)>& change);

  // Finding.
  std::optional<robotlink::Instant> nextTime() const;
  /// Finds a robot by its name in the replay; null if there is none.
  ReplayRobot* findRobot(const std::string& name) const;
  /// Finds a stream by its path in the replay.
  Place placeOf(const std::string& stream) const;
  /// The time of the instant `count` instants of a stream after (negative: before) now.
  std::optional<robotlink::Instant> countedTime(const std::string& stream, int count) const;
  /// See ReplayRun::timeOfFrame().
  std::optional<robotlink::Instant> timeOfFrame(const std::string& process, std::uint64_t frame) const;
  /// The stream of a process's frames, by "<robot>/<process>"; empty if that is no such name.
  static std::string framesOf(const std::string& process);
  /// Parts of ReplayRun::describe().
  void describeLogs(robotcontrol::ReplayStatus& status) const;
  void describePackages(robotcontrol::ReplayStatus& status) const;
  void describeFrame(robotcontrol::ReplayStatus& status) const;

  ReplayOptions options;
  Listeners listeners;
  std::vector<std::unique_ptr<Source>> sources;
  /// That of the options; null if they have none.
  std::shared_ptr<const robotcontrol::ColorTable> colorTable;
  robotlink::Instant now;
  std::string stepProcess;

  // During a jump, nothing is published. What the programs send meanwhile is collected in the members below
  // and published at its end.
  /// Whether a jump is in progress.
  bool quiet = false;
  /// All messages of streams with a history; see hasHistory().
  std::vector<robotlink::StreamMessage> history;
  /// The newest message of each other stream, by path.
  std::map<std::string, robotlink::StreamMessage> newest;
  /// Results of requests; null if there are none.
  std::shared_ptr<robotlink::SharedDebugQueue> answers;
  /// Texts of the replay itself that were not published yet.
  std::vector<robotlink::StreamMessage> notes;
};

}  // namespace app
