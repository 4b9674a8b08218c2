// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl compare`: which solution of a task is better, in figures.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <set>

#include "app/core/platform/NumberRange.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/compare/CompareReport.h"
#include "app/robotctl/compare/RunExecution.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/truth/TruthErrors.h"

namespace app {
namespace {

struct CompareArguments {
  std::string task;
  std::vector<std::string> solutions;
  std::vector<std::string> logs;
  std::string scene;
  int seeds = 10;
  RunExecution execution;
};

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Each run has one thread, as there are as many runs as cores.
std::vector<PlannedRun> solutionRuns(const CompareArguments& arguments) {
  std::vector<PlannedRun> runs;
  const std::vector<std::string>& options = arguments.execution.options;
  // A walk is measured without errors of what its robot believes.
  const bool isWalk =
      std::ranges::any_of(options, [](const std::string& option) { return option.starts_with("--walk"); });
  for (const std::string& solution : arguments.solutions) {
    const std::string choice = arguments.task + "=" + solution;
    for (const std::string& log : arguments.logs) {
      runs.push_back({solution,
                      log,
                      {"run", "--platform", "log:" + wholePath(log), "--package", "all=recomputed",
                       "--solution", choice, "--errors", "--json"}});
    }
    for (int i = 0; !arguments.scene.empty() && i < arguments.seeds; ++i) {
      const std::string seed = std::to_string(arguments.execution.firstSeed + static_cast<std::uint64_t>(i));
      runs.push_back(
          {solution,
           "seed " + seed,
           {"sim", wholePath(arguments.scene), "--threads", "1", "--seconds",
            fmt::format("{}", arguments.execution.seconds), "--seed", seed, "--solution", choice, "--json"}});
      auto& words = runs.back().arguments;
      if (!isWalk) words.emplace_back("--errors");
      words.insert(words.end(), options.begin(), options.end());
    }
  }
  return runs;
}

/// Executes what has no result yet, and writes the report.
int compare(const CompareArguments& arguments, const std::vector<PlannedRun>& runs,
            const ReportTitle& titled) {
  if (const auto tried = arguments.execution.tryOut(runs); !tried) return printErrors({tried.error()});
  const auto results = arguments.execution.execute(runs);
  if (!results) return printErrors({results.error()});
  ReportTitle title = titled;
  title.missing = results->missing;
  Comparison comparison;
  for (const auto& [run, printed] : results->results)
    comparison.add(run.variant, run.subject, figuresIn(printed));
  if (auto written = writeReport(arguments.execution.out, comparison, title); !written)
    return printErrors({written.error()});
  printDifferences(comparison);
  std::cout << (std::filesystem::path(arguments.execution.out) / "report.html").string() << "\n";
  return results->missing.empty() ? kDone : kFailed;
}

/// The packages that solutions of a task yield.
std::vector<std::string> packagesOf(const CompareArguments& arguments) {
  std::set<std::string> packages;
  for (const std::string& solution : arguments.solutions) {
    const auto& outputs = robotlink::SolutionRegistry::find(arguments.task, solution)->outputs;
    packages.insert(outputs.begin(), outputs.end());
  }
  return {packages.begin(), packages.end()};
}

/// Returns a note about a task for whose packages the simulator has no ground truth; empty if it has.
std::string noTruthNote(const CompareArguments& arguments, const std::vector<std::string>& packages) {
  const auto& compared = robotlink::TruthErrors::packages();
  if (std::ranges::any_of(packages, [&](const std::string& package) {
        return std::ranges::find(compared, package) != compared.end();
      }))
    return {};
  std::string text = fmt::format(
      "The task {} has no ground truth: its output ({}) is neither right "
      "nor wrong by itself. Compare its effects: goals and other figures "
      "of the game, the errors of other tasks, and its computing time.",
      arguments.task, joined(packages));
  if (arguments.task == "motion")
    text += " The options '-- --walk 1' measure how fast and how upright a robot walks.";
  if (!arguments.logs.empty()) text += " On a log the task's output has no effect: use --scene.";
  return text;
}

int usage(const char* command, const std::string& text) {
  std::cerr << "robotctl " << command << ": " << text << "\n";
  return kUsage;
}

int runCompare(const CompareArguments& arguments) {
  if (arguments.scene.empty() == arguments.logs.empty())
    return usage("compare", "give either --scene or --log to compare on");
  if (std::set<std::string>(arguments.solutions.begin(), arguments.solutions.end()).size() !=
      arguments.solutions.size())
    return usage("compare", "name each solution only once");
  if (!arguments.logs.empty() && !arguments.execution.options.empty())
    return usage("compare", "options after -- are for simulations: use --scene");
  if (const auto known = checkSolutions(arguments.task, arguments.solutions); !known)
    return usage("compare", known.error().text);
  if (arguments.solutions.size() < 2) return usage("compare", "name two solutions or more");
  std::string command = "robotctl compare --task " + arguments.task + " --solutions " +
                        fmt::format("{}", fmt::join(arguments.solutions, ","));
  command += arguments.scene.empty()
                 ? " --log " + shellLine(arguments.logs)
                 : fmt::format(" --scene {} --seeds {} --seconds {}", shellLine({arguments.scene}),
                               arguments.seeds, arguments.execution.seconds);
  command += " --out " + arguments.execution.out;
  if (!arguments.execution.options.empty()) command += " -- " + shellLine(arguments.execution.options);
  ReportTitle title{arguments.task + ": " + joined(arguments.solutions), command, {}};
  title.packages = packagesOf(arguments);
  if (const std::string note = noTruthNote(arguments, title.packages); !note.empty()) {
    std::cout << note << "\n";
    title.notes.push_back(note);
  }
  return compare(arguments, solutionRuns(arguments), title);
}

}  // namespace

void addCompareCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare", "Compares solutions of a task with the truth, in a simulation with many seeds or on logs");
  command->add_option("--task", arguments->task, "The task, such as ball-model")->required();
  command->add_option("--solutions", arguments->solutions, "The solutions to compare, two or more")
      ->delimiter(',')
      ->required();
  command
      ->add_option("--log", arguments->logs,
                   "Logs with ground truth (oracle/world), on which everything is recomputed")
      ->check(CLI::ExistingFile);
  command->add_option("--scene", arguments->scene, "A scene that is simulated with each solution and seed");
  command->add_option("--seeds", arguments->seeds, "Number of seeds")
      ->check(numberFrom(1, 100000))
      ->capture_default_str();
  arguments->execution.addOptionsTo(*command);
  arguments->execution.addTo(*command);
  command->callback([arguments, &status] { status = withResources([&] { return runCompare(*arguments); }); });
}

}  // namespace app
