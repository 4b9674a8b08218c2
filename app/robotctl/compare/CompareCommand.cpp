// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl compare`: which solution of a task is better, in figures.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "app/core/platform/NumberRange.h"
#include "app/core/program/ShippedFiles.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/compare/CompareReport.h"
#include "app/robotctl/compare/RunPool.h"
#include "app/robotctl/compare/SlurmBatch.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/Solution.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kShowEvery{500};

struct CompareArguments {
  std::string task;
  std::vector<std::string> solutions;
  std::vector<std::string> logs;
  std::string scene;
  int seeds = 10;
  std::uint64_t firstSeed = 1;
  double seconds = 60;
  std::string out;
  std::string batch;
  unsigned parallel = 0;  // 0: as many as there are cores
  int retries = 1;
};

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Whether all of these are solutions of the task; else what is wrong.
std::string wrongSolutions(const CompareArguments& arguments) {
  std::vector<std::string> known;
  for (const auto& solution : robotlink::SolutionRegistry::all())
    if (solution.task == arguments.task) known.push_back(solution.name);
  if (known.empty()) return "there is no task '" + arguments.task + "' with solutions";
  for (const std::string& solution : arguments.solutions) {
    if (std::ranges::find(known, solution) != known.end()) continue;
    const std::string near = robotlink::nearest(solution, known);
    return "the task " + arguments.task + " has no solution '" + solution + "'" +
           (near.empty() ? "" : "; did you mean '" + near + "'?") + " There are " + joined(known) + ".";
  }
  return "";
}

/// A file by its whole path, since jobs run in other folders; the name of a shipped scene as it is.
std::string wholePath(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::exists(name, ignored) ? std::filesystem::absolute(name).string() : name;
}

/// Each run has one thread, as there are as many runs as cores.
std::vector<PlannedRun> solutionRuns(const CompareArguments& arguments) {
  std::vector<PlannedRun> runs;
  for (const std::string& solution : arguments.solutions) {
    const std::string choice = arguments.task + "=" + solution;
    for (const std::string& log : arguments.logs) {
      runs.push_back({solution,
                      log,
                      {"run", "--platform", "log:" + wholePath(log), "--package", "all=recomputed",
                       "--solution", choice, "--errors", "--json"}});
    }
    for (int i = 0; !arguments.scene.empty() && i < arguments.seeds; ++i) {
      const std::string seed = std::to_string(arguments.firstSeed + static_cast<std::uint64_t>(i));
      runs.push_back({solution,
                      "seed " + seed,
                      {"sim", wholePath(arguments.scene), "--threads", "1", "--seconds",
                       fmt::format("{}", arguments.seconds), "--seed", seed, "--solution", choice, "--errors",
                       "--json"}});
    }
  }
  return runs;
}

/// A line on a terminal that shows how far it is.
class ProgressLine {
 public:
  explicit ProgressLine(std::size_t before) : before_(before) {}

  bool show(const RunProgress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (now - shown_ >= kShowEvery || progress.running == 0) {
      shown_ = now;
      std::string line = fmt::format("\r{} of {} runs", before_ + progress.done, before_ + progress.all);
      if (progress.failed > 0) line += fmt::format(", {} failed", progress.failed);
      if (progress.done > 0 && progress.running > 0) {
        const double spent = std::chrono::duration<double>(now - begin_).count();
        const auto left = static_cast<double>(progress.all - progress.done - progress.failed);
        line += fmt::format(", about {:.0f} s left", spent / static_cast<double>(progress.done) * left);
      }
      std::cerr << line << "    " << std::flush;
    }
    return !Interrupt::noted();
  }

 private:
  const std::size_t before_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point shown_{};
};

/// Executes runs here or in Slurm, those that fail again; those that still have no result are returned.
robotlink::Result<std::vector<PlannedRun>> executeAll(const CompareArguments& arguments,
                                                      const RunFiles& files, std::vector<PlannedRun> runs,
                                                      std::size_t before) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  for (int attempt = 0; attempt <= arguments.retries && !runs.empty() && !Interrupt::noted(); ++attempt) {
    ProgressLine line(before);
    const auto look = [&](const RunProgress& progress) { return line.show(progress); };
    if (arguments.batch.empty()) {
      RunPool pool(files, arguments.parallel > 0 ? arguments.parallel : cores);
      runs = pool.execute(std::move(runs), look);
    } else {
      auto left = SlurmBatch(files).execute(runs, look);
      if (!left) return tl::unexpected(left.error());
      runs = std::move(*left);
    }
    std::cerr << "\n";
  }
  return runs;
}

/// What a run printed; fails if that is no object of JSON.
robotlink::Result<std::vector<Figure>> readFigures(const std::filesystem::path& file) {
  const auto text = robotlink::readFile(file);
  if (!text) return tl::unexpected(text.error());
  try {
    return figuresIn(nlohmann::json::parse(*text));
  } catch (const nlohmann::json::exception& error) {
    return robotlink::failure("compare.result", file.string() + " has no figures: " + error.what(), {},
                              {file.string()});
  }
}

void printDifferences(const Comparison& comparison) {
  for (const Difference& one : comparison.differences()) {
    if (!one.isReal()) continue;
    std::cout << fmt::format("{}: {} {} than {}, by {:.4g} [{:.3g}, {:.3g}]{}{} in {} runs\n", one.figure,
                             one.second, one.change.mean < 0 ? "less" : "more", one.first,
                             std::abs(one.change.mean), one.change.low, one.change.high,
                             one.unit.empty() ? "" : " ", one.unit, one.subjects);
  }
}

/// Executes what has no result yet, and writes the report.
int compare(const CompareArguments& arguments, const std::vector<PlannedRun>& runs,
            const ReportTitle& titled) {
  const Interrupt interrupt;
  const auto files = RunFiles::in(std::filesystem::path(arguments.out) / "runs");
  if (!files) return printErrors({files.error()});
  std::vector<PlannedRun> open;
  std::ranges::copy_if(runs, std::back_inserter(open),
                       [&](const PlannedRun& run) { return !files->isDone(run); });
  const auto missing = executeAll(arguments, *files, open, runs.size() - open.size());
  if (!missing) return printErrors({missing.error()});
  ReportTitle title = titled;
  for (const PlannedRun& run : *missing) {
    title.missing.push_back(run.variant + ", " + run.subject);
    std::cerr << "no result: " << title.missing.back() << "; see " << files->texts(run).string() << "\n";
  }
  Comparison comparison;
  for (const PlannedRun& run : runs) {
    if (!files->isDone(run)) continue;
    const auto figures = readFigures(files->result(run));
    if (!figures) return printErrors({figures.error()});
    comparison.add(run.variant, run.subject, *figures);
  }
  if (auto written = writeReport(arguments.out, comparison, title); !written)
    return printErrors({written.error()});
  printDifferences(comparison);
  std::cout << (std::filesystem::path(arguments.out) / "report.html").string() << "\n";
  if (Interrupt::noted()) std::cerr << "The same command goes on where this ended.\n";
  return missing->empty() ? kDone : kFailed;
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
    return usage("compare", "each solution can be named once");
  if (const std::string wrong = wrongSolutions(arguments); !wrong.empty()) return usage("compare", wrong);
  std::string command = "robotctl compare --task " + arguments.task + " --solutions " +
                        fmt::format("{}", fmt::join(arguments.solutions, ","));
  command += arguments.scene.empty()
                 ? " --log " + shellLine(arguments.logs)
                 : fmt::format(" --scene {} --seeds {} --seconds {}", shellLine({arguments.scene}),
                               arguments.seeds, arguments.seconds);
  return compare(
      arguments, solutionRuns(arguments),
      {arguments.task + ": " + joined(arguments.solutions), command + " --out " + arguments.out, {}});
}

/// Options about how the runs are executed.
void addExecution(CLI::App& command, CompareArguments& arguments) {
  command.add_option("--seconds", arguments.seconds, "Simulated seconds of each run")
      ->check(numberFrom(0.1, 1e6))
      ->capture_default_str();
  command.add_option("--seed", arguments.firstSeed, "The first seed; the others follow it")
      ->capture_default_str();
  command
      .add_option("--out", arguments.out, "The folder of results and report; results that are there count")
      ->required();
  command.add_option("--batch", arguments.batch, "Hands the runs to a batch system, as an array of jobs")
      ->check(CLI::IsMember({"slurm"}));
  command
      .add_option("--parallel", arguments.parallel, "How many run at once here (as many as there are cores)")
      ->check(numberFrom(1, 1024));
  command.add_option("--retries", arguments.retries, "How often a run that fails is tried again")
      ->check(numberFrom(0, 10))
      ->capture_default_str();
}

}  // namespace

void addCompareCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare", "Compares solutions of a task with the truth, in a simulation with many seeds or on logs");
  command->add_option("--task", arguments->task, "The task, such as ball-model")->required();
  command->add_option("--solutions", arguments->solutions, "Its solutions that are compared, two or more")
      ->delimiter(',')
      ->required();
  command
      ->add_option("--log", arguments->logs, "Logs with the truth (oracle/world), on which all is recomputed")
      ->check(CLI::ExistingFile);
  command->add_option("--scene", arguments->scene, "A scene that is simulated with each solution and seed");
  command->add_option("--seeds", arguments->seeds, "How many seeds")
      ->check(numberFrom(1, 100000))
      ->capture_default_str();
  addExecution(*command, *arguments);
  command->callback([arguments, &status] { status = withResources([&] { return runCompare(*arguments); }); });
}

}  // namespace app
