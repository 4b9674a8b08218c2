// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl layout`: checks and draws process layouts.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/robotctl/Commands.h"
#include "robotlink/base/Printable.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/process/Layout.h"

namespace app {
namespace {

struct LayoutArguments {
  std::string file;
  std::string robot = "ers210";
};

/// Reads and checks a layout; if it is valid, passes it to `use`.
template <typename Use>
int withLayout(const LayoutArguments& arguments, Use use) {
  const auto robot =
      robotlink::readRobotDescription(robotlink::resource("robots/" + arguments.robot + ".yaml"));
  if (!robot) return printErrors(robot.error());
  const auto layout = robotlink::readLayout(arguments.file);
  if (!layout) return printErrors(layout.error());
  const robotlink::TaskCatalog catalog = robotlink::registeredTasks();
  const robotlink::PlatformPackages platform{robot->offers, robot->takes, robotlink::debugPackages()};
  const robotlink::Errors errors = robotlink::checkLayout(*layout, catalog, platform);
  if (!errors.empty()) return printErrors(errors);
  use(*layout, catalog, platform);
  return kDone;
}

int check(const LayoutArguments& arguments) {
  return withLayout(arguments, [&](const robotlink::Layout& layout, const auto&, const auto&) {
    std::size_t tasks = 0;
    for (const auto& process : layout.processes) tasks += process.tasks.size();
    std::cout << arguments.file << ": layout " << robotlink::printable(layout.name)
              << " can be run: " << layout.processes.size() << " processes, " << tasks << " tasks\n";
  });
}

int graph(const LayoutArguments& arguments) {
  return withLayout(arguments, [](const auto& layout, const auto& catalog, const auto& platform) {
    std::cout << robotlink::printableLines(robotlink::layoutGraph(layout, catalog, platform));
  });
}

}  // namespace

void addLayoutCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<LayoutArguments>();
  CLI::App* layout = app.add_subcommand("layout", "Checks and draws process layouts");
  layout->require_subcommand(1);
  const auto add = [&](const char* name, const char* help, int (*run)(const LayoutArguments&)) {
    CLI::App* command = layout->add_subcommand(name, help);
    command->add_option("file", arguments->file, "A layout file")->required();
    command->add_option("--robot", arguments->robot, "The kind of robot that the layout is for")
        ->capture_default_str();
    command->callback([arguments, run, &status] { status = withResources([&] { return run(*arguments); }); });
  };
  add("check", "Checks whether a layout can run; if not, prints the reason with file, line and column",
      check);
  add("graph", "Prints the graph of processes and packages as Graphviz text", graph);
}

}  // namespace app
