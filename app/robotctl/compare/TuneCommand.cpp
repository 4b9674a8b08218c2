// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl tune`: better parameters of a solution, found by simulation.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/core/platform/NumberRange.h"
#include "app/core/program/PresetOverrides.h"
#include "app/core/program/RobotFiles.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/compare/Tuning.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/ParameterText.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/ParsedMessage.h"

namespace app {
namespace {

struct TuneArguments {
  std::string task, solution, robot;
  std::vector<std::string> parameters;
  std::vector<std::string> algorithms{"crs2", "esch", "sbplx"};
  int evaluations = 200;
  TuningTask tuning;
};

int wrongTuning(const std::string& text) {
  std::cerr << "robotctl tune: " << text << "\n";
  return kUsage;
}

tl::expected<robotlink::SolutionParameters, robotlink::Errors> parametersOf(const TuneArguments& arguments) {
  const auto description = readRobot(arguments.robot);
  if (!description) return tl::unexpected(description.error());
  robotlink::RobotSetup setup;
  setup.name = arguments.robot;
  setup.description = **description;
  return robotlink::SolutionParameters::load(
      *robotlink::SolutionRegistry::find(arguments.task, arguments.solution), parameterFolder(**description),
      setup);
}

/// The robot's parameter file with the tuned numbers in their places.
tl::expected<std::string, robotlink::Errors> tunedText(const robotlink::SolutionParameters& parameters,
                                                       const robotlink::Preset& preset,
                                                       const TuneArguments& arguments) {
  robotcontrol::ParameterValues values;
  values.set_task(arguments.task);
  values.set_solution(arguments.solution);
  parameters.describe(values);
  const auto requests = requestsOf(preset, {values});
  const auto& tuned = requests.front().set_parameters().value();
  const auto after = robotlink::parsedMessage(tuned.type(), tuned.data());
  const auto text = robotlink::readFile(values.file());
  if (!text) return robotlink::parameterText(*after);
  return robotlink::editedParameterText(*text, values.file(), *parameters.message(), *after);
}

/// The command that does the same again.
std::string commandOf(const TuneArguments& arguments) {
  const TuningTask& tuning = arguments.tuning;
  std::vector<std::string> words{
      "robotctl",         "tune",    "--task",        arguments.task, "--solution",
      arguments.solution, "--robot", arguments.robot, "--scene",      tuning.scene};
  for (const std::string& parameter : arguments.parameters) {
    words.emplace_back("--parameter");
    words.push_back(parameter);
  }
  for (std::string word :
       {std::string("--figure"), tuning.figure, std::string("--algorithms"),
        fmt::format("{}", fmt::join(arguments.algorithms, ",")), std::string("--evaluations"),
        std::to_string(arguments.evaluations), std::string("--seeds"), std::to_string(tuning.seeds),
        std::string("--held-out"), std::to_string(tuning.heldOut), std::string("--seed"),
        std::to_string(tuning.execution.firstSeed), std::string("--seconds"),
        fmt::format("{}", tuning.execution.seconds), std::string("--out"), tuning.execution.out})
    words.push_back(std::move(word));
  if (tuning.maximize) words.emplace_back("--maximize");
  if (!tuning.execution.options.empty()) words.emplace_back("--");
  words.insert(words.end(), tuning.execution.options.begin(), tuning.execution.options.end());
  return shellLine(words);
}

/// Prints how much better the tuned parameters are with seeds that the search has not seen.
int printOutcome(const Comparison& comparison, const TuningTask& tuning) {
  for (const Difference& one : comparison.differences()) {
    if (one.figure != tuning.figure) continue;
    const auto row = std::ranges::find(comparison.rows(), tuning.figure, &Comparison::Row::name);
    const double today = Comparison::meanOf(*row, "today").mean,
                 tuned = Comparison::meanOf(*row, "tuned").mean;
    const bool isBetter = one.isReal() && (one.change.mean > 0) == tuning.maximize;
    std::cout << fmt::format(
        "{} with {} held-out seeds: {:.4g}{}, before {:.4g} ({:+.1f} %, change [{:.3g}, {:.3g}]){}\n",
        one.figure, one.subjects, tuned, one.unit.empty() ? "" : " " + one.unit, today,
        today != 0 ? 100 * (tuned - today) / std::abs(today) : 0, one.change.low, one.change.high,
        isBetter ? "" : ": not better");
    return isBetter ? kDone : kFailed;
  }
  std::cerr << "robotctl tune: too few runs with held-out seeds have a result\n";
  return kFailed;
}

robotlink::Result<void> writeTuned(const Tuning& tuning, const TuneArguments& arguments,
                                   const ParameterSpace& space,
                                   const robotlink::SolutionParameters& parameters) {
  const std::filesystem::path out(arguments.tuning.execution.out);
  const robotlink::Preset preset = space.presetAt(tuning.best().point);
  if (auto written = robotlink::Presets::saveFile(out / "tuned.preset.json", preset); !written)
    return written;
  if (auto written = robotlink::writeFileAtomically(out / "course.csv", tuning.courseCsv()); !written)
    return written;
  const auto text = tunedText(parameters, preset, arguments);
  if (!text) return tl::unexpected(text.error().front());
  return robotlink::writeFileAtomically(out / (arguments.task + "." + arguments.solution + ".textproto"),
                                        *text);
}

int tune(const TuneArguments& arguments, const ParameterSpace& space,
         const robotlink::SolutionParameters& parameters) {
  Tuning tuning(arguments.tuning, space);
  const auto isWhole = tuning.search();
  std::cerr << "\n";
  if (!isWhole) return printErrors({isWhole.error()});
  if (!*isWhole || !tuning.best().value) return kFailed;
  if (auto written = writeTuned(tuning, arguments, space, parameters); !written)
    return printErrors({written.error()});
  const auto comparison = tuning.validate();
  if (!comparison) return printErrors({comparison.error()});
  const std::filesystem::path out(arguments.tuning.execution.out);
  const ReportTitle title{arguments.task + "/" + arguments.solution + ": " + arguments.tuning.figure,
                          commandOf(arguments), tuning.missing(), tuning.tables()};
  if (auto written = writeReport(out, *comparison, title); !written) return printErrors({written.error()});
  const int status = printOutcome(*comparison, arguments.tuning);
  std::cout << (out / "report.html").string() << "\n" << (out / "tuned.preset.json").string() << "\n";
  return status;
}

int runTune(TuneArguments& arguments) {
  if (const auto known = checkSolutions(arguments.task, {arguments.solution}); !known)
    return wrongTuning(known.error().text);
  const auto* solution = robotlink::SolutionRegistry::find(arguments.task, arguments.solution);
  if (solution->parameters == nullptr)
    return wrongTuning(arguments.task + "/" + arguments.solution + " has no parameters");
  const auto parameters = parametersOf(arguments);
  if (!parameters) return printErrors(parameters.error());
  const auto space = ParameterSpace::of(arguments.parameters, *solution, *parameters);
  if (!space) return wrongTuning(space.error().text);
  arguments.tuning.solution = arguments.task + "=" + arguments.solution;
  const int stages = static_cast<int>(arguments.algorithms.size());
  for (int i = 0; i < stages; ++i) {
    const int share = arguments.evaluations / stages + (i < arguments.evaluations % stages ? 1 : 0);
    arguments.tuning.stages.push_back(
        {arguments.algorithms[static_cast<std::size_t>(i)], share, arguments.tuning.execution.firstSeed});
  }
  return tune(arguments, *space, *parameters);
}

}  // namespace

void addTuneCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<TuneArguments>();
  TuningTask& tuning = arguments->tuning;
  CLI::App* command = app.add_subcommand(
      "tune",
      "Searches for better parameters of a solution by simulation, and tests them with held-out seeds");
  command->add_option("--task", arguments->task, "The task, such as motion")->required();
  command->add_option("--solution", arguments->solution, "Its solution")->required();
  command
      ->add_option("--robot", arguments->robot,
                   "The kind of robot whose parameters these are, such as ers210")
      ->required();
  command
      ->add_option(
          "--parameter", arguments->parameters,
          "NAME=LOW:HIGH, a number and its range; NAME alone: from half of its value to twice as much")
      ->required();
  command->add_option("--scene", tuning.scene, "The scene that is simulated with each candidate and seed")
      ->required();
  command
      ->add_option(
          "--figure", tuning.figure,
          "The figure to minimize, by its name in a report: 'models/ball position mean', 'walk forward'")
      ->required();
  command->add_flag("--maximize", tuning.maximize, "Maximizes the figure instead");
  command->add_option("--seeds", tuning.seeds, "Number of seeds for each candidate")
      ->check(numberFrom(1, 10000))
      ->capture_default_str();
  command
      ->add_option(
          "--held-out", tuning.heldOut,
          "Number of held-out seeds with which the best candidate is compared with the current values")
      ->check(numberFrom(2, 10000))
      ->capture_default_str();
  command
      ->add_option("--algorithms", arguments->algorithms,
                   "Algorithms of NLopt, run one after another, comma-separated")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->check(CLI::IsMember(Optimizer::algorithms()))
      ->capture_default_str();
  command->add_option("--evaluations", arguments->evaluations, "Total number of candidates tried")
      ->check(numberFrom(1, 1e6))
      ->capture_default_str();
  tuning.execution.addOptionsTo(*command);
  tuning.execution.addTo(*command);
  command->callback([arguments, &status] { status = withResources([&] { return runTune(*arguments); }); });
}

}  // namespace app
