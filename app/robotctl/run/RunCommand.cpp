// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl run`: robot programs on whatever the registered platforms can run without a window.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/core/platform/HeadlessRun.h"
#include "app/core/program/SolutionChoices.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"

namespace app {
namespace {

struct RunArguments {
  HeadlessChoices choices;
  std::vector<std::string> solutions;
  bool asJson = false;
};

int usage(const robotlink::Error& error) {
  std::cerr << "robotctl run: " << error.text << "\n";
  return kUsage;
}

int runPlatform(RunArguments& arguments) {
  const auto platform = headlessPlatformFor(arguments.choices);
  if (!platform) return usage(platform.error());
  auto solutions = solutionsOf(arguments.solutions);
  if (!solutions) return usage(solutions.error());
  arguments.choices.solutions = std::move(*solutions);
  const auto run = platform->prepare(arguments.choices);
  if (!run) return usage(run.error());
  TerminalProgress progress;
  std::vector<LogInput> inputs;
  const auto input = [&](const std::string& source) -> robotlink::Result<std::filesystem::path> {
    auto file = LogInput::of(source);
    if (!file) return tl::unexpected(file.error());
    return inputs.emplace_back(std::move(*file)).path();
  };
  const auto summary = (*run)({std::cerr, &Interrupt::noted, progress.function(), input});
  progress.erase();
  if (!summary) return printErrors(summary.error());
  std::cout << (arguments.asJson ? summary->json : summary->text);
  return summary->status;
}

/// "log:FILE, or ...; or a Pioneer: ..."
std::string helpOnPlatforms() {
  std::string help;
  for (const HeadlessPlatform& platform : headlessPlatforms())
    help += (help.empty() ? "" : "; or ") + std::string(platform.help);
  return help;
}

}  // namespace

void addRunCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<RunArguments>();
  HeadlessChoices& choices = arguments->choices;
  choices.record.compression = "zstd";
  CLI::App* command =
      app.add_subcommand("run", "Runs robot programs on logs, as fast as possible, or on a real robot");
  command->add_option("--platform", choices.platform, helpOnPlatforms())->required();
  command->add_option(
      "--layout", choices.layout,
      "A process layout: a file, or the name of a shipped one; else that of the log or of the robot");
  command->add_option("--solution", arguments->solutions, "TASK=SOLUTION instead of the layout's");
  command->add_option(
      "--record", choices.record.file,
      "A new log (MCAP) of what was logged and what was recomputed, or of what happened on the robot");
  command
      ->add_option("--compression", choices.record.compression, "Compression of that log: none, lz4 or zstd")
      ->check(CLI::IsMember({"none", "lz4", "zstd"}))
      ->capture_default_str();
  command->add_flag("--json", arguments->asJson, "Prints the summary as one JSON object");
  for (const HeadlessPlatform& platform : headlessPlatforms()) {
    for (const PlatformField& option : platform.options) choices.options.addTo(*command, option);
  }
  command->callback(
      [arguments, &status] { status = withResources([&] { return runPlatform(*arguments); }); });
}

}  // namespace app
