// SPDX-License-Identifier: GPL-3.0-or-later
// The program robotctl: everything that works without a window.
#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>

#include "app/core/own/OwnProgramMain.h"
#include "app/core/plugins/Plugins.h"
#include "app/core/program/Abandoned.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "robotlink/base/Printable.h"
#include "robotlink/base/Resources.h"

namespace app {

int printErrors(const robotlink::Errors& errors) {
  // The reader of standard output has ended, which is not reported as an error.
  if (Interrupt::signal() == SIGPIPE) return kFailed;
  std::cerr << robotlink::printableLines(robotlink::describe(errors)) << "\n";
  return kFailed;
}

int withResources(const std::function<int()>& command) {
  const auto found = robotlink::checkResources();
  return found ? command() : printErrors({found.error()});
}

namespace {

int run(int argc, char** argv) {
  CLI::App app("Everything that RobotControl can do without a window.", "robotctl");
  app.require_subcommand(1);
  app.set_version_flag("--version", ROBOTCONTROL_VERSION);
  addPluginOptions(app);
  app.footer(
      "Exit status: 0 done, 1 failed, 2 wrong usage, 3 done, but some input was damaged.\nIf a signal ends "
      "it before it is "
      "done, 128 and the signal's number (130 after Ctrl-C); files are then\ncomplete or absent.\n'robotctl "
      "COMMAND --help' shows a command's options.");
  int status = kDone;
  addSimCommand(app, status);
  addCompareCommand(app, status);
  addTournamentCommand(app, status);
  addTuneCommand(app, status);
  addSceneCommand(app, status);
  addLayoutCommand(app, status);
  addLogCommand(app, status);
  addRunCommand(app, status);
  addPlatformCommand(app, status);
  addLaunchCommand(app, status);
  addRobotsCommand(app, status);
  addDeployCommand(app, status);
  addWatchCommand(app, status);
  addRequestCommand(app, status);
  addColorCommand(app, status);
  addCommandsCommand(app, status);
  addDoCommand(app, status);
  addPluginsCommand(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return kUsage;
  }
  return status;
}

/// Flushes standard output and returns the final exit status.
int finish(int status) {
  errno = 0;
  std::cout.flush();
  const bool written = std::fflush(stdout) == 0 && std::cout && std::ferror(stdout) == 0;
  const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : std::string();
  const int signal = Interrupt::signal();
  if (signal == SIGPIPE && !written) return Interrupt::exitStatus(signal);
  if (!written) {
    std::cerr << "robotctl: cannot write to standard output" << reason << "; the output is incomplete\n";
    if (status == kDone) status = kFailed;
  }
  // A command that runs until a signal arrives has succeeded then.
  const bool isDone = status == kDone || status == kDoneWithLosses;
  return signal != 0 && signal != SIGPIPE && !isDone ? Interrupt::exitStatus(signal) : status;
}

}  // namespace
}  // namespace app

int main(int argc, char** argv) {
  if (const auto status = app::ownProgramMain(argc, argv)) return *status;
  app::loadPlugins(app::pluginOptions(argc, argv));
  for (const std::string& problem : app::pluginProblems())
    std::cerr << "robotctl: plug-in " << robotlink::printable(problem) << "\n";
  const app::SignalWatch watch;
  int status = app::kFailed;
  try {
    status = app::run(argc, argv);
  } catch (const std::exception& exception) {
    std::cerr << "robotctl: " << exception.what() << "\n";
  }
  status = app::finish(status);
  // A module that never returns does not keep the program.
  app::leave(status);
  return status;
}
