// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/RunExecution.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <thread>
#include <utility>

#include "app/core/platform/NumberRange.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/compare/RunInputs.h"
#include "app/robotctl/compare/RunPool.h"
#include "app/robotctl/compare/SlurmBatch.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/Solution.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kShowEvery{500};
constexpr char kSeconds[] = "--seconds";

/// A line on a terminal that shows how far it is.
class ProgressLine {
 public:
  ProgressLine(std::size_t before, const std::string& partOf) : before_(before), partOf_(partOf) {}

  bool show(const RunProgress& progress) {
    const auto now = std::chrono::steady_clock::now();
    // In a file there is a line where something has changed.
    if (!isTerminal_ &&
        std::exchange(ended_, progress.done + progress.failed) == progress.done + progress.failed)
      return !Interrupt::noted();
    if (!isTerminal_ || now - shown_ >= kShowEvery || progress.running == 0) {
      shown_ = now;
      std::string line = fmt::format("{}{}{} of {} runs", isTerminal_ ? "\r" : "", partOf_,
                                     before_ + progress.done, before_ + progress.all);
      if (progress.failed > 0) line += fmt::format(", {} failed", progress.failed);
      if (progress.done > 0 && progress.running > 0) {
        const double spent = std::chrono::duration<double>(now - begin_).count();
        const auto left = static_cast<double>(progress.all - progress.done - progress.failed);
        line += fmt::format(", about {:.0f} s left", spent / static_cast<double>(progress.done) * left);
      }
      std::cerr << line << (isTerminal_ ? "    " : "\n") << std::flush;
    }
    return !Interrupt::noted();
  }

 private:
  const std::size_t before_;
  const std::string& partOf_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  const bool isTerminal_ = ::isatty(STDERR_FILENO) != 0;
  std::size_t ended_ = 0;
  std::chrono::steady_clock::time_point shown_{};
};

/// Reads the output of a run; fails if it is not a JSON object.
robotlink::Result<nlohmann::json> readResult(const std::filesystem::path& file) {
  const auto text = robotlink::readFile(file);
  if (!text) return tl::unexpected(text.error());
  try {
    return nlohmann::json::parse(*text);
  } catch (const nlohmann::json::exception& error) {
    return robotlink::failure("compare.result", file.string() + " has no figures: " + error.what(), {},
                              {file.string()});
  }
}

}  // namespace

robotlink::Result<void> checkSolutions(const std::string& task, const std::vector<std::string>& solutions) {
  std::vector<std::string> known, tasks;
  for (const auto& solution : robotlink::SolutionRegistry::all()) {
    if (solution.task == task) known.push_back(solution.name);
    if (tasks.empty() || tasks.back() != solution.task) tasks.push_back(solution.task);
  }
  const auto unknown = [](const std::string& what, const std::string& name, std::vector<std::string>& there) {
    std::ranges::sort(there);
    there.erase(std::unique(there.begin(), there.end()), there.end());
    return robotlink::failure("compare.unknown",
                              what + " '" + name + "'" + robotlink::suggestion(name, there) + "; there are " +
                                  fmt::format("{}", fmt::join(there, ", ")),
                              {}, {name});
  };
  if (known.empty()) return unknown("there is no task", task, tasks);
  for (const std::string& solution : solutions)
    if (std::ranges::find(known, solution) == known.end())
      return unknown("the task " + task + " has no solution", solution, known);
  return {};
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

void RunExecution::addTo(CLI::App& command) {
  command.add_option("--seconds", seconds, "Simulated seconds of each run")
      ->check(numberFrom(0.1, 1e6))
      ->capture_default_str();
  command.add_option("--seed", firstSeed, "The first seed; the others follow it")->capture_default_str();
  command
      .add_option(
          "--out", out,
          "The folder for results and report. Existing results are reused as long as the program, its "
          "resources and the named files are unchanged")
      ->required();
  command.add_option("--batch", batch, "Submits the runs to a batch system as a job array")
      ->check(CLI::IsMember({"slurm"}));
  command
      .add_option("--parallel", parallel,
                  "Maximum number of concurrent local runs (default: number of cores)")
      ->check(numberFrom(1, 1024));
  command.add_option("--retries", retries, "How many times a failed run is retried")
      ->check(numberFrom(0, 10))
      ->capture_default_str();
}

void RunExecution::addOptionsTo(CLI::App& command) {
  command.add_option("options", options, "Options of `robotctl sim` for each run, after --");
}

robotlink::Result<std::vector<PlannedRun>> RunExecution::executeAll(const RunFiles& files,
                                                                    std::vector<PlannedRun> runs,
                                                                    std::size_t before) const {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  for (int attempt = 0; attempt <= retries && !runs.empty() && !Interrupt::noted(); ++attempt) {
    ProgressLine line(before, partOf);
    const auto look = [&](const RunProgress& progress) { return line.show(progress); };
    if (batch.empty()) {
      RunPool pool(files, parallel > 0 ? parallel : cores);
      runs = pool.execute(std::move(runs), look);
    } else {
      auto left = SlurmBatch(files).execute(runs, look);
      if (!left) return tl::unexpected(left.error());
      runs = std::move(*left);
    }
    if (partOf.empty() && ::isatty(STDERR_FILENO) != 0) std::cerr << "\n";
  }
  return runs;
}

robotlink::Result<RunExecution::Results> RunExecution::tryOut(const std::vector<PlannedRun>& runs) const {
  const Interrupt interrupt;
  std::vector<PlannedRun> first;
  for (const PlannedRun& run : runs) {
    const auto length = std::ranges::find(run.arguments, kSeconds);
    if (length == run.arguments.end() || length + 1 == run.arguments.end()) continue;
    if (std::ranges::find(first, run.variant, &PlannedRun::variant) != first.end()) continue;
    PlannedRun& shortened = first.emplace_back(run);
    shortened.arguments[static_cast<std::size_t>(length - run.arguments.begin()) + 1] = "0";
    shortened.inputs = inputsOf(run);
  }
  const auto files = RunFiles::in(std::filesystem::path(out) / "check");
  if (!files) return tl::unexpected(files.error());
  std::vector<PlannedRun> open;
  std::ranges::remove_copy_if(first, std::back_inserter(open),
                              [&](const PlannedRun& run) { return files->isDone(run); });
  RunPool pool(*files, std::max(1U, std::thread::hardware_concurrency()));
  std::string texts;
  for (const PlannedRun& run : pool.execute(open, [](const RunProgress&) { return !Interrupt::noted(); })) {
    std::string text = robotlink::readFile(files->texts(run)).value_or("");
    while (text.ends_with('\n')) text.pop_back();
    // The same is often wrong with several.
    if (texts.find(text) == std::string::npos || text.empty())
      texts += fmt::format("{}{}: {}", texts.empty() ? "" : "\n", run.variant, text.empty() ? "fails" : text);
  }
  if (!texts.empty() && !Interrupt::noted()) return robotlink::failure("compare.run", texts, {}, {texts});
  Results results;
  for (const PlannedRun& run : first) {
    if (!files->isDone(run)) continue;
    auto printed = readResult(files->result(run));
    if (!printed) return tl::unexpected(printed.error());
    results.results.emplace_back(run, std::move(*printed));
  }
  return results;
}

robotlink::Result<RunExecution::Results> RunExecution::execute(std::vector<PlannedRun> runs) const {
  const Interrupt interrupt;
  for (PlannedRun& run : runs) run.inputs = inputsOf(run);
  const auto files = RunFiles::in(std::filesystem::path(out) / "runs");
  if (!files) return tl::unexpected(files.error());
  std::vector<PlannedRun> open;
  std::ranges::copy_if(runs, std::back_inserter(open),
                       [&](const PlannedRun& run) { return !files->isDone(run); });
  const auto failed = executeAll(*files, open, runs.size() - open.size());
  if (!failed) return tl::unexpected(failed.error());
  Results results;
  for (const PlannedRun& run : *failed) {
    results.missing.push_back(run.variant + ", " + run.subject);
    // After a signal, most of them have not begun.
    if (Interrupt::noted()) continue;
    std::cerr << "no result: " << results.missing.back() << "; see " << files->texts(run).string() << "\n";
  }
  for (const PlannedRun& run : runs) {
    if (!files->isDone(run)) continue;
    auto printed = readResult(files->result(run));
    if (!printed) return tl::unexpected(printed.error());
    results.results.emplace_back(run, std::move(*printed));
  }
  if (Interrupt::noted()) std::cerr << "Run the same command again to continue.\n";
  return results;
}

}  // namespace app
