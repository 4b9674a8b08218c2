// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "app/core/ChangeSteps.h"
#include "app/core/LogWriteJob.h"
#include "app/core/OpenPlatform.h"
#include "robotlink/commands/CommandTable.h"

namespace app {

/// Everything of the workbench except its window: what is open, and the table of all commands. Only in one
/// thread, that of the GUI, which calls tick() at 30 Hz.
class Workbench : public OpenPlatform {
 public:
  /// See OpenPlatform; attaches all commands that need no window.
  explicit Workbench(std::filesystem::path userFolder);

  /// See OpenPlatform; also goes where steps to changes lead.
  void tick();
  robotlink::CommandTable& commands() { return commands_; }
  /// Adds a function that returns whether something other than opening that a command has begun still runs,
  /// so that scripts wait for it. If that fails, the function fails once, with the reason.
  void addJob(std::function<robotlink::Result<bool>()> isRunning) { jobs_.push_back(std::move(isRunning)); }
  /// Whether one of them runs; fails, once, with why one has failed.
  robotlink::Result<bool> working() const;

 private:
  std::vector<std::function<robotlink::Result<bool>()>> jobs_;
  LogWriteJob logWriting_;
  ChangeSteps changeSteps_{*this};
  robotlink::CommandTable commands_;
};

}  // namespace app
