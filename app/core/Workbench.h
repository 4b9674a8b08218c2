// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/core/OpenPlatform.h"
#include "robotlink/commands/CommandTable.h"

namespace app {

/// Everything of the workbench except its window: what is open, and the table of all commands. Only in one
/// thread, that of the GUI, which calls tick() at 30 Hz.
class Workbench : public OpenPlatform {
 public:
  /// See OpenPlatform; attaches all commands that need no window.
  explicit Workbench(std::filesystem::path userFolder);

  robotlink::CommandTable& commands() { return commands_; }

 private:
  robotlink::CommandTable commands_;
};

}  // namespace app
