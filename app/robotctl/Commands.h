// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/core/platform/ExitStatus.h"
#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

// Each of these functions adds a subcommand to `app`. When it is chosen, its callback runs the command and
// sets `status`, an ExitStatus, which must outlive the parsing.
void addSimCommand(CLI::App& app, int& status);
void addCompareCommand(CLI::App& app, int& status);
void addTournamentCommand(CLI::App& app, int& status);
void addTuneCommand(CLI::App& app, int& status);
void addSceneCommand(CLI::App& app, int& status);
void addLayoutCommand(CLI::App& app, int& status);
void addLogCommand(CLI::App& app, int& status);
void addColorCommand(CLI::App& app, int& status);
void addCommandsCommand(CLI::App& app, int& status);
void addDoCommand(CLI::App& app, int& status);
void addPluginsCommand(CLI::App& app, int& status);
void addRunCommand(CLI::App& app, int& status);
void addPlatformCommand(CLI::App& app, int& status);
void addLaunchCommand(CLI::App& app, int& status);
void addRobotsCommand(CLI::App& app, int& status);
void addDeployCommand(CLI::App& app, int& status);
void addWatchCommand(CLI::App& app, int& status);
void addRequestCommand(CLI::App& app, int& status);

/// Adds `--plugin` and `--no-plugins`, which main() has obeyed before (app/core/plugins/Plugins.h).
void addPluginOptions(CLI::App& app);

/// Prints all errors to stderr, one per line, and returns kFailed.
int printErrors(const robotlink::Errors& errors);

/// Runs a command that needs the folder `resources`; prints an error if that cannot be found. Returns an
/// ExitStatus.
int withResources(const std::function<int()>& command);

}  // namespace app
