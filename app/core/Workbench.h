// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/core/PlatformThread.h"
#include "app/core/Recording.h"
#include "app/core/pioneer/PioneerRun.h"
#include "app/core/replay/ReplayRun.h"
#include "app/core/simulated/SimulatedRun.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/session/CommandTable.h"
#include "robotlink/session/Session.h"

namespace app {

/// Everything of the workbench except its window: a session, the platform that feeds it (a simulation, a real
/// robot, or logs), the recording, and the table of all commands. Only in one thread, that of the GUI, which
/// calls tick() at 30 Hz.
class Workbench {
 public:
  /// The settings of the recording, and the debug keys that were on for each robot, are kept below
  /// `userFolder`.
  explicit Workbench(std::filesystem::path userFolder);
  ~Workbench();

  robotlink::Session& session() { return session_; }
  robotlink::CommandTable& commands() { return commands_; }
  Recording& recording() { return recording_; }

  /// Starts loading a simulation. The result arrives in a later tick(), as for all functions that open or
  /// close something or change the layout.
  void load(RunOptions options);
  /// Opens logs. `layout` is that of the programs that run on them; empty: the one in each log.
  void openLogs(std::vector<ReplayLog> logs, const std::filesystem::path& layout = {});
  /// Adds a log to those that are open, on the same time line.
  void addLog(ReplayLog log);
  /// Connects a real robot, or a robot of another simulator. The result says only whether its program can be
  /// run; the progress of the connection is published on its stream link/status.
  void connectRobot(PioneerOptions options);
  /// Retries the connection of connectRobot() at once if it was lost. Fails if no such robot is open.
  robotlink::Result<void> connectNow();
  /// Ends what runs.
  void close();
  /// Restarts the robots' programs in another layout.
  void setLayout(const std::filesystem::path& file);

  /// Sends a request to what runs. A refusal is passed to the handler of onErrors().
  void ask(robotcontrol::Request request);

  /// Applies the results of loading, updates the session, and calls the handlers below.
  void tick();
  /// The handler is called with what runs now when something was loaded or closed, or a layout was changed.
  void onLoaded(std::function<void(const LoadedPlatform&)> handler) { onLoaded_ = std::move(handler); }
  /// The handler is called if something could not be loaded, in which case what ran before continues; if a
  /// request was refused; and with warnings.
  void onErrors(std::function<void(const robotlink::Errors&)> handler) { onErrors_ = std::move(handler); }

  /// What runs; null until something was loaded for the first time.
  const LoadedPlatform* loaded() const { return loaded_ ? &*loaded_ : nullptr; }
  /// Whether something is being loaded now.
  bool loading() const { return loading_ > 0; }
  /// Which share of a file that is being opened was read, in [0, 1]; unset if none is.
  std::optional<double> progress() const;
  /// The name of that file; empty if there is none.
  std::string openingName() const;
  /// Cancels opening that file; what ran before continues.
  void cancelOpening();

  /// Saves the modes of each robot's debug keys for the next start. Those of a robot that has not yet
  /// switched on what was saved before stay as saved. Fails if a file cannot be written.
  robotlink::Result<void> keepKeys();

  /// The shipped scenes and maps; the shipped layouts.
  static std::vector<std::filesystem::path> scenes();
  static std::vector<std::filesystem::path> layouts();
  /// A kind of robot that can be added to a simulated world, since it has a description and a model.
  struct RobotKind {
    /// "p3at"
    std::string name;
    /// "Pioneer 3-AT"
    std::string title;
    /// Whether such robots play in teams.
    bool plays = false;
  };
  /// All of these kinds, sorted by name.
  static std::vector<RobotKind> simulatedRobots();
  /// The shipped layouts that can be run by a kind of robot.
  static std::vector<std::filesystem::path> layoutsFor(const robotlink::RobotDescription& robot);
  /// A shipped scene by its name ("field2002"), or any other by its path.
  static std::filesystem::path sceneNamed(const std::string& name);
  /// A shipped layout by its name ("compact"), or any other by its path.
  static std::filesystem::path layoutNamed(const std::string& name);
  /// The simulation that is opened by default.
  static RunOptions defaultOptions();

 private:
  /// The progress of a file that is being opened, shared with the platform's thread.
  struct Opening {
    std::string name;
    std::atomic<double> share = 0;
    std::atomic<bool> canceled = false;
  };
  /// What a result is about: another platform, or another layout on the same one.
  enum class Change { kPlatform, kLayout };
  /// A result from the platform's thread.
  struct Outcome {
    Change change;
    tl::expected<LoadedPlatform, robotlink::Errors> loaded;
  };
  /// Adds the commands "simulation.*".
  void addSimulationCommands();
  /// Adds the command "layout.open".
  void addLayoutCommand();
  /// Executes the command "simulation.setup".
  robotlink::Result<void> setUp(const std::vector<robotlink::CommandTable::Value>& values);
  /// Begins a new opening_, and returns the function that updates it.
  logplayer::LogFile::Progress newOpening(const std::filesystem::path& file);
  /// Returns a handler that enqueues the result for tick().
  PlatformThread::LoadHandler outcomeOf(Change change);
  /// Applies a result from the platform's thread.
  void apply(Outcome outcome);
  /// The options of the simulation that runs or ran last. Another scene is opened with its layouts and
  /// settings.
  RunOptions lastSimulation() const;
  /// Passes a request of the session to the recording or the platform.
  void take(const robotcontrol::Request& request);
  /// Calls the handler of onErrors().
  void report(const robotlink::Errors& errors);
  /// Switches on the debug keys that were on when the robot was last open; at first, those of a shipped
  /// preset.
  void switchKeysOn(const std::string& robot);
  /// Requests an action of ControlSimulation; a negative speed leaves the speed as it is.
  robotlink::Result<void> control(int action, double speed = -1);

  std::filesystem::path userFolder_;
  robotlink::Session session_;
  robotlink::CommandTable commands_;
  Recording recording_;
  /// From the platform's thread. Unbounded: each outcome ends what loading_ counts, and there are no more
  /// than a person has begun.
  robotlink::BoundedQueue<Outcome> outcomes_{std::numeric_limits<std::size_t>::max()};
  std::optional<LoadedPlatform> loaded_;
  /// Shared with the platform's thread.
  struct LastSimulation;
  std::shared_ptr<LastSimulation> lastSimulation_;
  /// How many of the requests of switchKeysOn() a robot has not answered yet, by robot. Shared with the
  /// handlers of the answers, which count down.
  std::map<std::string, std::shared_ptr<int>> keysToSwitchOn_;
  std::function<void(const LoadedPlatform&)> onLoaded_;
  std::function<void(const robotlink::Errors&)> onErrors_;
  /// How many results are still to come.
  int loading_ = 0;
  /// The last file whose opening was begun; null if none is in progress.
  std::shared_ptr<Opening> opening_;
  /// The last member, since its thread uses the others.
  PlatformThread platform_;
};

}  // namespace app
