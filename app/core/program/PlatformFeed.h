// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/program/PacedThread.h"
#include "app/core/program/PlatformAdapter.h"
#include "app/core/program/StopSwitch.h"
#include "logplayer/file/LogFile.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotcontrol {
class Request;
}
namespace robotlink {
struct FieldDescription;
struct RobotDescription;
}  // namespace robotlink

namespace app {

/// What runs in the workbench: for its window.
struct LoadedPlatform {
  std::string adapter;               ///< the name of its PlatformAdapter; empty: nothing is loaded
  std::optional<PlatformTime> time;  ///< nothing: nothing is loaded
  std::vector<std::string> sources;  ///< the scene's file, the logs' files, the robot's address
  /// For the window's title: "field2002", "game.mcap", "tcp://localhost:8101"; empty if nothing is loaded.
  std::string title;
  std::map<std::string, std::shared_ptr<const robotlink::RobotDescription>> robots;
  std::shared_ptr<const robotlink::FieldDescription> field;
  std::filesystem::path layout;  ///< empty: the one in the log, or none
  /// What a person chose for the programs before, and they cannot fulfill in this layout; a sentence each.
  std::vector<std::string> lostChoices;

  const std::string& name() const { return title; }
  bool isSimulated() const { return time == PlatformTime::kSimulated; }
  bool isLogged() const { return time == PlatformTime::kLogged; }
  bool isReal() const { return time == PlatformTime::kReal; }
};

/// A platform with its robots' programs as the workbench runs it: feeds a session with what happens, at a
/// speed, and fulfils requests. One thread, that of PlatformThread.
class PlatformFeed {
 public:
  enum class Answer { kHere, kByProgram };  ///< who answers a request that was accepted
  /// How time goes, for a platform that takes the place of this one.
  struct Going {
    bool running = false;
    double speed = 1;
  };

  virtual ~PlatformFeed() = default;

  /// From here on it tells what happens; first, everything that there is to show now.
  virtual void begin() = 0;
  /// As PacedThread::Work.
  virtual std::optional<PacedThread::Clock::time_point> due() = 0;
  virtual void step() = 0;

  /// Does it, or hands it to whoever does it: by the table of requests (robotlink/debugging/RequestKinds.h).
  robotlink::Result<Answer> fulfil(const robotcontrol::Request& request);
  /// Starts the programs anew in another layout; if that is not possible, all goes on as before.
  virtual robotlink::Errors setLayout(const std::filesystem::path& file) = 0;
  virtual LoadedPlatform describe() const = 0;
  /// Stops a real robot from any thread, whatever this one waits for. Null: what runs here stands while this
  /// thread is held up.
  virtual std::shared_ptr<StopSwitch> stopSwitch() const { return nullptr; }
  /// Whether it runs, how fast, where it is.
  virtual void publishStatus() = 0;

  // While another platform of the same adapter takes its place.
  /// Gives up what the other one may need, too, before it is known whether that one can be run. False: it
  /// cannot go on after that, and has to be ended first.
  virtual bool makeWay() { return true; }
  /// It goes on after makeWay(), as the other one cannot be run.
  virtual robotlink::Errors goOn() { return {}; }
  virtual Going going() const { return {}; }
  virtual void inheritPlayback(const Going&) {}
  /// What a person chose for the robots' programs, by the robots' names.
  virtual std::map<std::string, ProgramOverrides> overrides() const { return {}; }

  /// One that has this log beside what this one has, and goes on where this one stands. Refused where no log
  /// is open.
  virtual PlatformOpening::Made withLog(const std::filesystem::path& file, robotlink::Duration offset,
                                        const logplayer::LogFile::Progress& progress) const;
  /// A line to a robot that was lost is opened again at once; where there is none nothing happens.
  virtual void connectNow() {}

 protected:
  /// To a robot: its program, or its platform.
  virtual robotlink::Result<void> requestRobot(const robotcontrol::Request& request) = 0;
  /// What only a simulation can do.
  virtual robotlink::Result<void> requestSimulation(const robotcontrol::Request& request);
  /// What only a log that is played can do.
  virtual robotlink::Result<void> requestReplay(const robotcontrol::Request& request);
};

}  // namespace app
