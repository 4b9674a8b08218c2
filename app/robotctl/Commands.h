// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

/// How programs of this project end.
enum ExitStatus { kDone = 0, kFailed = 1, kUsage = 2, kDoneWithLosses = 3 };

// Each adds a subcommand to `app`; when it was chosen, `status` is set by its callback.
void addSimCommand(CLI::App& app, int& status);
void addLayoutCommand(CLI::App& app, int& status);
void addLogCommand(CLI::App& app, int& status);
void addColorCommand(CLI::App& app, int& status);
void addRunCommand(CLI::App& app, int& status);

/// Prints all errors on stderr, one a line; kFailed.
int printErrors(const robotlink::Errors& errors);

/// Runs what needs the folder `resources`, unless that is not to be found, which it says; an ExitStatus.
int withResources(const std::function<int()>& command);

}  // namespace app
