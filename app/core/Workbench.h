// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/core/SimulationThread.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/session/CommandTable.h"
#include "robotlink/session/Session.h"

namespace app {

/// All of the workbench that is not its window: a session, the simulation that feeds it, and the commands that both offer. The
/// thread that owns it calls tick() at 30 Hz.
class Workbench {
 public:
  /// Debug keys that were on at the end of the last session are kept below `userFolder`.
  explicit Workbench(std::filesystem::path userFolder);
  ~Workbench();

  robotlink::Session& session() { return session_; }
  robotlink::CommandTable& commands() { return commands_; }

  /// Starts loading; the outcome arrives in a later tick().
  void load(RunOptions options);
  void setLayout(const std::filesystem::path& file);

  /// Takes in what is new; calls the handlers below.
  void tick();
  /// A scene or layout was loaded: what runs now.
  void onLoaded(std::function<void(const SimulationThread::Loaded&)> handler) { onLoaded_ = std::move(handler); }
  /// A scene or layout could not be loaded; what ran before goes on.
  void onErrors(std::function<void(const robotlink::Errors&)> handler) { onErrors_ = std::move(handler); }

  const SimulationThread::Loaded* loaded() const { return loaded_ ? &*loaded_ : nullptr; }
  /// Is a scene being loaded now?
  bool loading() const { return loading_ > 0; }

  /// Keeps the debug keys that are on, for the next start.
  robotlink::Result<void> keepKeys();

  /// The shipped ones.
  static std::vector<std::filesystem::path> scenes();
  static std::vector<std::filesystem::path> layouts();
  static RunOptions defaultOptions();

 private:
  using Outcome = tl::expected<SimulationThread::Loaded, robotlink::Errors>;
  void addCommands();
  void addSimulationCommands();
  void addRobotCommands();
  void takeIn(Outcome outcome);
  void switchKeysOn(const std::string& robot);
  robotlink::Result<void> control(int action, double speed = -1);

  std::filesystem::path userFolder_;
  std::set<std::string> switchedOn_;  ///< robots whose keys were set at the start
  robotlink::Session session_;
  robotlink::CommandTable commands_;
  robotlink::BoundedQueue<Outcome> outcomes_{64};
  std::optional<SimulationThread::Loaded> loaded_;
  std::function<void(const SimulationThread::Loaded&)> onLoaded_;
  std::function<void(const robotlink::Errors&)> onErrors_;
  int loading_ = 0;
  SimulationThread simulation_;  // last: it uses the others
};

}  // namespace app
