// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl launch`: all programs of a layout on this machine.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/program/ShippedFiles.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/run/LaunchedPrograms.h"
#include "robotlink/process/Layout.h"

namespace app {
namespace {

/// The time that the programs may take to end after Ctrl-C.
constexpr std::chrono::seconds kLaunchGrace{5};

struct LaunchArguments {
  std::string layout;
  /// The options that are passed to `robotctl run`.
  std::vector<std::string> others;
};

/// Returns the words as a user types them in a shell.
std::string typed(const std::vector<std::string>& words) {
  std::string text = "robotctl";
  for (const std::string& word : words) {
    const bool isPlain =
        !word.empty() && word.find_first_of(" \t\"'\\$&|;<>()*?[]{}!#~`") == std::string::npos;
    text += isPlain ? " " + word : " '" + word + "'";
  }
  return text;
}

robotlink::Errors startAll(const LaunchArguments& arguments, const robotlink::Layout& layout,
                           LaunchedPrograms& programs) {
  robotlink::Errors errors;
  for (const auto& program : layout.programs) {
    std::vector<std::string> words{"run", "--layout", arguments.layout, "--program", program.name, "--local"};
    words.insert(words.end(), arguments.others.begin(), arguments.others.end());
    if (const auto started = programs.start(program.name, words, typed(words)); !started)
      errors.push_back(started.error());
  }
  return errors;
}

/// Returns when all programs have ended.
void watch(LaunchedPrograms& programs) {
  std::optional<std::chrono::steady_clock::time_point> end;
  while (programs.anyRuns()) {
    programs.look();
    const auto now = std::chrono::steady_clock::now();
    if (!end && Interrupt::noted()) {
      programs.interrupt();
      end = now + kLaunchGrace;
    }
    if (end && now > *end) programs.kill();
  }
}

int launch(const LaunchArguments& arguments) {
  const auto layout = robotlink::readLayout(layoutNamed(arguments.layout));
  if (!layout) return printErrors(layout.error());
  if (layout->programs.empty()) {
    return printErrors({{"launch.programs",
                         "layout " + layout->name +
                             " names no programs; add 'programs:', or run it with robotctl run --layout",
                         {layout->name},
                         {layout->file, 0, 0}}});
  }
  const Interrupt interrupt;
  LaunchedPrograms programs(std::cout);
  if (const auto errors = startAll(arguments, *layout, programs); !errors.empty()) return printErrors(errors);
  watch(programs);
  return programs.anyFailed() ? kFailed : kDone;
}

}  // namespace

void addLaunchCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<LaunchArguments>();
  CLI::App* command = app.add_subcommand(
      "launch",
      "Starts all programs that a layout names under 'programs' on this machine, and prints their output "
      "after their names. Ctrl-C ends all; if one crashes, the others continue");
  command->add_option("LAYOUT", arguments->layout, "A process layout: a file, or the name of a shipped one")
      ->required();
  command->prefix_command();
  command->footer("Everything after LAYOUT is passed as options of robotctl run to each of the programs.");
  command->callback([command, arguments, &status] {
    arguments->others = command->remaining();
    status = withResources([&] { return launch(*arguments); });
  });
}

}  // namespace app
