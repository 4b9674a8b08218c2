// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/PacedThread.h"
#include "app/core/PioneerRun.h"
#include "app/core/ReplayRun.h"
#include "app/core/SimulatedRun.h"
#include "robotlink/base/Error.h"

namespace robotcontrol {
class Request;
}

namespace app {

/// What runs in the workbench: for its window.
struct LoadedPlatform {
  std::map<std::string, std::shared_ptr<const robotlink::RobotDescription>> robots;
  std::shared_ptr<const robotlink::FieldDescription> field;
  std::filesystem::path layout;  ///< empty: the one in the log, or none
  std::optional<RunOptions> simulation;
  std::optional<PioneerOptions> pioneer;  ///< a real robot
  std::vector<ReplayLog> logs;            ///< not empty: they are replayed
  /// What a person chose for the programs before, and they cannot fulfill in this layout; a sentence each.
  std::vector<std::string> lostChoices;

  /// For the window's title: "field2002", "game.mcap", "tcp://localhost:8101"; empty if nothing is loaded.
  std::string name() const;
};

/// A platform with its robots' programs as the workbench runs it: feeds a session with what happens, at a
/// speed, and fulfils requests. One thread, that of PlatformThread.
class PlatformFeed {
 public:
  enum class Answer { kHere, kByProgram };  ///< who answers a request that was accepted

  virtual ~PlatformFeed() = default;

  /// From here on it tells what happens; first, everything that there is to show now.
  virtual void begin() = 0;
  /// As PacedThread::Work.
  virtual std::optional<PacedThread::Clock::time_point> due() = 0;
  virtual void step() = 0;

  virtual robotlink::Result<Answer> fulfil(const robotcontrol::Request& request) = 0;
  /// Starts the programs anew in another layout; if that is not possible, all goes on as before.
  virtual robotlink::Errors setLayout(const std::filesystem::path& file) = 0;
  virtual LoadedPlatform describe() const = 0;
  /// Stops a real robot from any thread, whatever this one waits for. Null: what runs here stands while this
  /// thread is held up.
  virtual std::shared_ptr<StopSwitch> stopSwitch() const { return nullptr; }
  /// Whether it runs, how fast, where it is.
  virtual void publishStatus() = 0;
};

}  // namespace app
