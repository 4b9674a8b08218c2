// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "app/robotctl/Commands.h"
#include "robotlink/base/Resources.h"

namespace app {

int printErrors(const robotlink::Errors& errors) {
  std::cerr << robotlink::describe(errors) << "\n";
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
  app.footer("Exit status: 0 done, 1 failed, 2 wrong usage, 3 done with losses.\n"
             "'robotctl COMMAND --help' tells more.");
  int status = kDone;
  addSimCommand(app, status);
  addLayoutCommand(app, status);
  addLogCommand(app, status);
  addRunCommand(app, status);
  addColorCommand(app, status);
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

}  // namespace
}  // namespace app

int main(int argc, char** argv) {
  try {
    return app::run(argc, argv);
  } catch (const std::exception& exception) {
    std::cerr << "robotctl: " << exception.what() << "\n";
    return app::kFailed;
  }
}
