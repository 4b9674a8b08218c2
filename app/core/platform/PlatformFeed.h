// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/platform/PlatformAdapter.h"
#include "app/core/platform/StopSwitch.h"
#include "logplayer/file/LogFile.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/threads/PacedThread.h"

namespace robotcontrol {
class Request;
}
namespace robotlink {
struct FieldDescription;
struct RobotDescription;
}  // namespace robotlink

namespace app {

/// Texts that count instead of what files have, such as those that are being edited; by the whole path, with
/// links resolved, of each file.
using FileTexts = std::map<std::filesystem::path, std::string>;

/// A description of the platform that runs in the workbench, for its window. A plain value; the default says
/// that nothing is loaded.
struct LoadedPlatform {
  /// The name of its PlatformAdapter; empty if nothing is loaded.
  std::string adapter;
  /// Unset if nothing is loaded.
  std::optional<TimeKind> time;
  /// The scene's file, the logs' files, or the robot's address.
  std::vector<std::string> sources;
  /// The title of the window: "field2002", "game.mcap", "tcp://localhost:8101"; empty if nothing is loaded.
  std::string title;
  /// The robots with their descriptions, by name.
  std::map<std::string, std::shared_ptr<const robotlink::RobotDescription>> robots;
  /// Null if the world has no field.
  std::shared_ptr<const robotlink::FieldDescription> field;
  /// The layout file of the (first) robot's program; empty if there is none, or if a log's own layout is
  /// used.
  std::filesystem::path layout;
  /// The layouts of robots that do not use the common one, by robot name.
  std::map<std::string, std::filesystem::path> otherLayouts = {};
  /// Whether only the robots' bodies are here, whose programs run remotely; then there are no layouts.
  bool areBodies = false;
  /// The user's overrides that the programs cannot fulfill in this layout, as a sentence each.
  std::vector<std::string> lostChoices;
  /// A text on how much of a scene is left out, if no robot has a log that says so; empty if nothing is.
  std::string leftOut = {};
  /// The reports of the previous platform about its end, as a sentence each: "p3at1: The platform was
  /// shut down in 12.5 ms."
  std::vector<std::string> ended;

  const std::string& name() const { return title; }
  /// The layout file of a robot's program; empty if there is none.
  std::filesystem::path layoutOf(const std::string& robot) const {
    const auto other = otherLayouts.find(robot);
    return other == otherLayouts.end() ? layout : other->second;
  }
  bool isSimulated() const { return time == TimeKind::kSimulated; }
  bool isLogged() const { return time == TimeKind::kLogged; }
  bool isReal() const { return time == TimeKind::kReal; }
};

/// A platform with the programs of its robots, as the workbench runs it: publishes to a session, goes at the
/// speed that the user chose, and fulfills requests. PlatformThread owns it and calls it in its thread only;
/// exceptions are noted. Derived classes are registered as PlatformAdapters.
class PlatformFeed {
 public:
  /// The way of answering an accepted request: by the caller of fulfill(), or by the robot's program in
  /// its debug queue.
  enum class Answer { kHere, kByProgram };
  /// The state of playback that a platform inherits from the one that it replaces.
  struct Going {
    bool running = false;
    /// Times real time; 0 means as fast as possible.
    double speed = 1;
  };
  /// The data of the session that someone reads: all of it if there is a window.
  struct Demand {
    /// Whether anything is.
    bool anything = true;
    /// Whether the poses of the bodies are.
    bool transforms = true;
    /// Whether a client reads the contact forces. Local views request them instead (ReadForces).
    bool forces = false;
    bool operator==(const Demand&) const = default;
  };

  virtual ~PlatformFeed() = default;

  /// Called once, when the session belongs to this platform: publishes the current state. From then on
  /// everything is published as it happens.
  virtual void begin() = 0;
  /// The real time of the next step, as for robotlink::PacedThread::Work; nothing while it is paused.
  virtual std::optional<robotlink::PacedThread::Clock::time_point> due() = 0;
  /// Makes the step that is due.
  virtual void step() = 0;

  /// Ends the programs and shuts the platforms of the robots down; returns what these report, as a sentence
  /// each, since the session already belongs to nobody. Called once; then the feed is destroyed.
  virtual std::vector<std::string> end() { return {}; }
  /// After end(): whether all modules of the programs have returned. Until then the feed must exist; nothing
  /// else is called. Any thread.
  virtual bool hasEnded() const { return true; }

  /// Fulfills a request or passes it to the program; the table of requests
  /// (robotlink/debugging/RequestKinds.h) says who is responsible. Fails with the reason if the request is
  /// refused.
  robotlink::Result<Answer> fulfill(const robotcontrol::Request& request);
  /// Restarts the programs in another layout. If that is impossible, the errors say why, and the programs
  /// that run continue.
  virtual robotlink::Errors setLayout(const std::filesystem::path& file) = 0;
  /// The same for one robot, or for those of a team. By default that is refused.
  virtual robotlink::Errors setLayoutOf(const std::string& name, const std::filesystem::path& file);
  /// Reads the file of what runs again, which was edited, and continues in it as far as that is possible.
  /// False: it has to be opened instead. Only simulations can do it. If it fails, everything continues as
  /// before. `texts` count instead of files, until it is loaded again. If it `mustFit`, it fails if something
  /// would be inside of something that is there now, which is put back otherwise.
  virtual tl::expected<bool, robotlink::Errors> reload(FileTexts texts, bool mustFit);
  /// Returns the opening that starts the same from its beginning, with `texts` in place of files. By default
  /// it cannot be opened.
  virtual PlatformOpening reopening(FileTexts texts) const;
  /// Whether describe() tells of other robots since this was called last, because a request was fulfilled.
  virtual bool takeDescriptionChange() { return false; }
  /// Describes what runs now.
  virtual LoadedPlatform describe() const = 0;
  /// The switch that stops robots from any thread, even while this one is blocked. Null for platforms without
  /// one, such as logs.
  virtual std::shared_ptr<StopSwitch> stopSwitch() const { return nullptr; }
  /// Publishes whether the platform runs, how fast, and where it is.
  virtual void publishStatus() = 0;
  /// From now on, status, transforms and the ends of frames need not be published repeatedly if they have no
  /// reader. Events and latched messages are always published. The present state is published when reading
  /// begins.
  virtual void setDemand(const Demand& demand) = 0;

  // The following four are for the replacement of this platform by another one of the same adapter.
  /// Releases what the other platform needs to be made, such as ports, before it is known whether that one
  /// can be run. What the other one needs only from its begin() on, such as the only connection to a robot,
  /// it finds released then.
  virtual void makeWay() {}
  /// Undoes makeWay(), since the other platform cannot be run.
  virtual robotlink::Errors restoreAfterMakeWay() { return {}; }
  /// The state of playback, for the platform that replaces this one.
  virtual Going going() const { return {}; }
  /// Continues at the state of playback of the platform that this one replaces.
  virtual void inheritPlayback(const Going&) {}
  /// The user's overrides, by robot. Empty where the adapter does not keep them for a later opening.
  virtual std::map<std::string, ProgramOverrides> overrides() const { return {}; }

  /// Makes a platform with one more log, at the instant where this one is; `offset` is added to the times
  /// of that log. Fails if no log is open. This platform does not change.
  virtual PlatformOpening::Made withLog(const std::filesystem::path& file, robotlink::Duration offset,
                                        const logplayer::LogFile::Progress& progress) const;
  /// Retries a lost connection to a robot at once; without one this has no effect.
  virtual void connectNow() {}

 protected:
  /// Passes a request to a robot: its program or its platform. Fails if it is refused.
  virtual robotlink::Result<void> requestRobot(const robotcontrol::Request& request) = 0;
  /// Fulfills requests that only a simulation can fulfill; by default they are refused.
  virtual robotlink::Result<void> requestSimulation(const robotcontrol::Request& request);
  /// Fulfills requests that only a log can fulfill; by default they are refused.
  virtual robotlink::Result<void> requestReplay(const robotcontrol::Request& request);
};

}  // namespace app
