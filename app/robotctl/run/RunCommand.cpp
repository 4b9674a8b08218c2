// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl run`: robot programs on whatever the registered platforms can run without a window.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "app/core/platform/HeadlessRun.h"
#include "app/core/platform/ProgramTroubles.h"
#include "app/core/program/PresetOverrides.h"
#include "app/core/program/SolutionChoices.h"
#include "app/core/spread/SpreadNetwork.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "app/robotctl/run/ListenOptions.h"

namespace app {
namespace {

struct RunArguments {
  HeadlessChoices choices;
  std::vector<std::string> solutions, shadows;
  std::string preset;
  bool asJson = false;
  ListenOptions listen;
};

int usage(const robotlink::Error& error) {
  std::cerr << "robotctl run: " << error.text << "\n";
  return kUsage;
}

/// Runs a platform that people at other programs watch and steer.
int serveRun(const HeadlessPlatform& platform, const RunArguments& arguments,
             const HeadlessConsole& console) {
  if (arguments.asJson) return usage({"usage", "with --listen there is no summary; omit --json", {}, {}});
  if (platform.prepareServing == nullptr)
    return usage({"usage", "--listen is not possible with " + std::string(platform.usage), {}, {}});
  auto serving = platform.prepareServing(arguments.choices, console);
  if (!serving) return usage(serving.error());
  const ServeOptions options{.seconds = serving->seconds,
                             .texts = serving->texts,
                             .troubles = std::make_shared<ProgramTroubles>(std::cerr)};
  return arguments.listen.serve(std::move(serving->opening), options, arguments.choices.record);
}

/// Runs the program of the layout that the user has named, if it is one without platform and debug process;
/// nothing if it is not.
std::optional<int> runOtherProgram(const HeadlessPlatform& platform, const RunArguments& arguments,
                                   const HeadlessConsole& console) {
  const SpreadOptions& spread = arguments.choices.spread;
  if (spread.program.empty()) return std::nullopt;
  if (platform.prepareOther == nullptr)
    return usage({"usage", "--program is not possible with " + std::string(platform.usage), {}, {}});
  const auto file = platform.layoutOf(arguments.choices);
  if (file.empty()) return usage({"usage", "--program needs --layout with this platform", {}, {}});
  const auto layout = robotlink::readLayout(file);
  if (!layout) return printErrors(layout.error());
  if (const auto network = spreadNetworkOf(*layout, spread); !network) return printErrors({network.error()});
  if (layout->findProgram(spread.program) == layout->mainProgram()) return std::nullopt;
  const auto run = platform.prepareOther(arguments.choices);
  if (!run) return usage(run.error());
  const Interrupt interrupt;
  const auto summary = (*run)(console);
  if (!summary) return printErrors(summary.error());
  std::cout << (arguments.asJson ? summary->json : summary->text);
  return summary->status;
}

int runPlatform(RunArguments& arguments) {
  const auto platform = headlessPlatformFor(arguments.choices);
  if (!platform) return usage(platform.error());
  auto solutions = solutionsOf(arguments.solutions);
  if (!solutions) return usage(solutions.error());
  arguments.choices.solutions = std::move(*solutions);
  auto shadows = shadowsOf(arguments.shadows);
  if (!shadows) return usage(shadows.error());
  arguments.choices.shadows = std::move(*shadows);
  if (!arguments.preset.empty()) {
    auto preset = presetToStartWith(arguments.preset);
    if (!preset) return printErrors(preset.error());
    arguments.choices.preset = std::make_shared<const robotlink::Preset>(std::move(*preset));
  }
  std::vector<LogInput> inputs;
  const auto input = [&](const std::string& source) -> robotlink::Result<std::filesystem::path> {
    auto file = LogInput::of(source);
    if (!file) return tl::unexpected(file.error());
    return inputs.emplace_back(std::move(*file)).path();
  };
  TerminalProgress progress;
  const HeadlessConsole console{std::cerr, &Interrupt::noted, progress.function(), input};
  if (const auto other = runOtherProgram(*platform, arguments, console)) return *other;
  if (arguments.listen.given()) return serveRun(*platform, arguments, console);
  const auto run = platform->prepare(arguments.choices);
  if (!run) return usage(run.error());
  const auto summary = (*run)(console);
  progress.erase();
  if (!summary) return printErrors(summary.error());
  std::cout << (arguments.asJson ? summary->json : summary->text);
  return summary->status;
}

void addSpreadOptions(CLI::App& command, SpreadOptions& spread) {
  auto* program =
      command
          .add_option(
              "--program", spread.program,
              "Runs one of the programs that the layout names under 'programs'; start the others with "
              "the same options, or all on this machine with robotctl launch. --listen, --record and "
              "the options for the robot's line act in the one that has the debug process")
          ->type_name("NAME");
  command
      .add_flag("--local", spread.local, "All programs run on this machine, whatever hosts the layout names")
      ->needs(program);
  command
      .add_option(
          "--dds-domain", spread.domain,
          "The programs communicate in this DDS domain, 0 to 230: use one for each group on a network")
      ->needs(program)
      ->check(CLI::Range(0, 230))
      ->capture_default_str();
}

/// "a log file, or ...; or a Pioneer: ..."
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
      app.add_subcommand("run",
                         "Runs robot programs on logs, as fast as possible, or on a real robot; with "
                         "--listen for others to watch and steer, logs in real time");
  command->add_option("--platform", choices.platform, helpOnPlatforms())->required();
  command->add_option(
      "--layout", choices.layout,
      "A process layout: a file, or the name of a shipped one; else that of the log or of the robot");
  command->add_option("--solution", arguments->solutions, "TASK=SOLUTION instead of the layout's");
  command->add_option(
      "--shadow", arguments->shadows,
      "TASK=SOLUTION to run in the shadow of the active one, on the same inputs; --errors gives it its own "
      "figures, and --record records its output, drawings and times");
  command->add_option("--preset", arguments->preset,
                      "A preset (a file, or a name of one of yours) with the keys, solutions and parameters "
                      "that a robot's program starts with");
  command->add_option(
      "--record", choices.record.file,
      "A new log (MCAP) of what was logged and what was recomputed, or of what happened on the robot");
  command
      ->add_option("--compression", choices.record.compression, "Compression of that log: none, lz4 or zstd")
      ->check(CLI::IsMember({"none", "lz4", "zstd"}))
      ->capture_default_str();
  addSpreadOptions(*command, choices.spread);
  arguments->listen.addTo(*command);
  command->add_flag("--json", arguments->asJson, "Prints the summary as one JSON object");
  for (const HeadlessPlatform& platform : headlessPlatforms()) {
    for (const PlatformField& option : platform.options) choices.options.addTo(*command, option);
  }
  command->callback(
      [arguments, &status] { status = withResources([&] { return runPlatform(*arguments); }); });
}

}  // namespace app
