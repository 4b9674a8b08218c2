// SPDX-License-Identifier: GPL-3.0-or-later
// robotctl do: runs lines of scripts in a running workbench.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/core/platform/NumberRange.h"
#include "app/robotctl/Commands.h"
#include "robotlink/base/Printable.h"
#include "robotlink/commands/CommandSocket.h"

namespace app {
namespace {

struct DoArguments {
  std::vector<std::string> lines;
  int pid = 0;
};

robotlink::Result<void> runLine(robotlink::CommandConnection& workbench, const std::string& line) {
  return workbench.send(line).and_then([&] {
    return workbench.receive(
        [](const std::string& text) { std::cout << robotlink::printableLines(text) << std::endl; });
  });
}

/// Runs one line after the other, until one fails.
int runLines(robotlink::CommandConnection& workbench, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (const auto done = runLine(workbench, line); !done)
      return printErrors({{done.error().id, line + ": " + done.error().text, {}, {}}});
  }
  return kDone;
}

/// The same with the lines of standard input, as they come.
int runInput(robotlink::CommandConnection& workbench) {
  std::string line;
  for (int number = 1; std::getline(std::cin, line); ++number) {
    if (const auto done = runLine(workbench, line); !done)
      return printErrors({{done.error().id, done.error().text, {}, {"standard input", number, 0}}});
  }
  return kDone;
}

int doIt(const DoArguments& arguments) {
  const auto folder = robotlink::commandSocketFolder();
  if (folder.empty()) {
    return printErrors({{"socket.folder",
                         "XDG_RUNTIME_DIR, the folder in which running workbenches are found, is not set",
                         {},
                         {}}});
  }
  auto workbench = robotlink::CommandConnection::connect(folder, arguments.pid);
  if (!workbench) return printErrors({workbench.error()});
  std::error_code failed;
  const auto here = std::filesystem::current_path(failed);
  if (const auto done = workbench->useFolder(here); !failed && !done) return printErrors({done.error()});
  return arguments.lines.empty() ? runInput(*workbench) : runLines(*workbench, arguments.lines);
}

}  // namespace

void addDoCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "do", "Run lines of scripts in a running workbench, one after another until one fails");
  const auto arguments = std::make_shared<DoArguments>();
  command->add_option("lines", arguments->lines,
                      "One line each, as in scripts: 'robot.stop on', 'wait until simulation.time > 5'; "
                      "default: read from standard input");
  command->add_option("--pid", arguments->pid, "The process id of the workbench; without it, the newest one")
      ->check(numberFrom(1, 1 << 30));
  command->callback([arguments, &status] { status = doIt(*arguments); });
}

}  // namespace app
