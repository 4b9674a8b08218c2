// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
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

/// All of the workbench that is not its window: a session, the platform that feeds it (a simulation or logs),
/// and the commands that all of them offer. The thread that owns it calls tick() at 30 Hz.
class Workbench {
 public:
  /// Debug keys that were on at the end of the last session are kept below `userFolder`.
  explicit Workbench(std::filesystem::path userFolder);
  ~Workbench();

  robotlink::Session& session() { return session_; }
  robotlink::CommandTable& commands() { return commands_; }
  Recording& recording() { return recording_; }

  /// Starts loading a simulation; the outcome arrives in a later tick().
  void load(RunOptions options);
  /// The same for logs; the layout is that of the programs that run on them, empty: the one in the log.
  void openLogs(std::vector<ReplayLog> logs, const std::filesystem::path& layout = {});
  /// One more to those that are open.
  void addLog(ReplayLog log);
  /// A real robot, or one of another simulator. The outcome says only whether its program can be run; how the
  /// connection does is told on its stream link/status.
  void connectRobot(PioneerOptions options);
  /// The robot of connectRobot() is sought again at once, if it is not connected.
  robotlink::Result<void> connectNow();
  /// Ends what runs.
  void close();
  void setLayout(const std::filesystem::path& file);

  /// Asks what runs for something; a refusal arrives at the handler of errors.
  void ask(robotcontrol::Request request);

  /// Takes in what is new; calls the handlers below.
  void tick();
  /// A scene, log or layout was loaded, or all was closed: what runs now.
  void onLoaded(std::function<void(const LoadedPlatform&)> handler) { onLoaded_ = std::move(handler); }
  /// Something could not be loaded, and what ran before goes on; or a request was refused.
  void onErrors(std::function<void(const robotlink::Errors&)> handler) { onErrors_ = std::move(handler); }

  /// Null before the first that could be loaded.
  const LoadedPlatform* loaded() const { return loaded_ ? &*loaded_ : nullptr; }
  /// Is something being loaded now?
  bool loading() const { return loading_ > 0; }
  /// How much of what is being opened has been read, in [0, 1]; nothing if nothing is.
  std::optional<double> progress() const;
  /// What that is: the name of its file.
  std::string openingName() const;
  /// Gives up opening it.
  void cancelOpening();

  /// Keeps the debug keys that are on, for the next start.
  robotlink::Result<void> keepKeys();

  /// The shipped ones.
  static std::vector<std::filesystem::path> scenes();
  static std::vector<std::filesystem::path> layouts();
  /// The kinds of robots that can be put into a simulated world: those that are described and have a model.
  struct RobotKind {
    std::string name;    ///< "p3at"
    std::string title;   ///< "Pioneer 3-AT"
    bool plays = false;  ///< in teams
  };
  static std::vector<RobotKind> simulatedRobots();
  /// Those of them in which robots of a kind can be run.
  static std::vector<std::filesystem::path> layoutsFor(const robotlink::RobotDescription& robot);
  /// A shipped scene by its name ("field2002"), or any by its path.
  static std::filesystem::path sceneNamed(const std::string& name);
  /// A shipped layout by its name ("compact"), or any by its path.
  static std::filesystem::path layoutNamed(const std::string& name);
  static RunOptions defaultOptions();

 private:
  /// Of a log or scene that is opened in the platform's thread.
  struct Opening {
    std::string name;
    std::atomic<double> share = 0;
    std::atomic<bool> canceled = false;
  };
  enum class Change { kPlatform, kLayout };
  struct Outcome {
    Change change;
    tl::expected<LoadedPlatform, robotlink::Errors> loaded;
  };
  void addSimulationCommands();
  void addLayoutCommand();
  robotlink::Result<void> setUp(const std::vector<robotlink::CommandTable::Value>& values);
  logplayer::LogFile::Progress newOpening(const std::filesystem::path& file);
  PlatformThread::LoadHandler outcomeOf(Change change);
  void apply(Outcome outcome);
  /// With which the last simulation runs or ran.
  RunOptions lastSimulation() const;
  void take(const robotcontrol::Request& request);
  void report(const robotlink::Errors& errors);
  void switchKeysOn(const std::string& robot);
  robotlink::Result<void> control(int action, double speed = -1);

  std::filesystem::path userFolder_;
  robotlink::Session session_;
  robotlink::CommandTable commands_;
  Recording recording_;
  robotlink::BoundedQueue<Outcome> outcomes_{64};
  std::optional<LoadedPlatform> loaded_;
  struct LastSimulation;  // also known to the platform's thread
  std::shared_ptr<LastSimulation> lastSimulation_;
  std::function<void(const LoadedPlatform&)> onLoaded_;
  std::function<void(const robotlink::Errors&)> onErrors_;
  int loading_ = 0;
  std::shared_ptr<Opening> opening_;  ///< the last one that was begun
  PlatformThread platform_;           // last: it uses the others
};

}  // namespace app
