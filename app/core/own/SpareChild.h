// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/core/own/ProgramChild.h"

namespace app {

/// A process that waits for the next program of a robot, so that its start takes no time: for programs
/// that are made repeatedly, as at each jump in a log. One thread at a time.
class SpareChild {
 public:
  /// The process that waits, if it still does, else one that is started now; then the next one is started.
  /// Arguments and errors are those of ProgramChild::start().
  robotlink::Result<ProgramChild> take(const std::filesystem::path& executable, const std::string& name);
  /// The process that waits; 0: none does.
  pid_t pid() const { return next_ ? next_->pid() : 0; }

 private:
  std::optional<ProgramChild> next_;
};

}  // namespace app
