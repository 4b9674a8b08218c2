// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Tuning.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/robotctl/Interrupt.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/base/bytes/Fnv.h"

namespace app {
namespace {

/// The cost of a candidate whose runs have no result: worse than any figure, and finite.
constexpr double kNoResult = 1e30;

/// The number of candidates to try before it counts that all have the same figure.
constexpr std::size_t kAlike = 4;

/// A name for a candidate that depends on its numbers only.
std::string candidateName(const std::vector<std::string>& numbers) {
  return fmt::format("candidate-{:016x}", robotlink::fnv1a(fmt::format("{}", fmt::join(numbers, " "))));
}

/// Errors are measured where the figure is one of them: "models/ball position mean".
bool isOfErrors(const std::string& figure) {
  const auto word = figure.substr(0, figure.find(' '));
  return word.find('/') != std::string::npos;
}

}  // namespace

robotlink::Result<std::vector<PlannedRun>> Tuning::runsOf(const std::string& variant,
                                                          const std::vector<double>& point,
                                                          std::uint64_t firstSeed, int seeds) const {
  const auto folder = std::filesystem::absolute(task_.execution.out) / "candidates";
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const auto preset = folder / (candidateName(space_.numbersAt(point)) + ".preset.json");
  if (!std::filesystem::exists(preset, ignored)) {
    if (auto saved = robotlink::Presets::saveFile(preset, space_.presetAt(point)); !saved)
      return tl::unexpected(saved.error());
  }
  std::vector<PlannedRun> runs;
  for (int i = 0; i < seeds; ++i) {
    const std::string seed = std::to_string(firstSeed + static_cast<std::uint64_t>(i));
    PlannedRun& run = runs.emplace_back(PlannedRun{variant, "seed " + seed, {"sim", wholePath(task_.scene)}});
    for (std::string word :
         {std::string("--threads"), std::string("1"), std::string("--seconds"),
          fmt::format("{}", task_.execution.seconds), std::string("--seed"), seed, std::string("--solution"),
          task_.solution, std::string("--preset"), preset.string(), std::string("--json")})
      run.arguments.push_back(std::move(word));
    if (isOfErrors(task_.figure)) run.arguments.emplace_back("--errors");
    run.arguments.insert(run.arguments.end(), task_.execution.options.begin(), task_.execution.options.end());
  }
  return runs;
}

robotlink::Result<std::optional<double>> Tuning::evaluate(const std::vector<double>& point) {
  const auto runs =
      runsOf(candidateName(space_.numbersAt(point)), point, task_.execution.firstSeed, task_.seeds);
  if (!runs) return tl::unexpected(runs.error());
  RunExecution execution = task_.execution;
  int all = 0;
  for (const Optimizer& stage : task_.stages) all += stage.evaluations;
  execution.partOf = fmt::format("candidate {} of {}", tried_.size() + 1, all + 1);
  if (!tried_.empty() && best().value) execution.partOf += fmt::format(", best {:.5g}", *best().value);
  execution.partOf += ": ";
  const auto results = execution.execute(*runs);
  if (!results) return tl::unexpected(results.error());
  if (results->results.size() < runs->size()) return std::nullopt;
  double sum = 0;
  for (const auto& [run, printed] : results->results) {
    std::vector<std::string> names;
    const auto figures = figuresIn(printed);
    for (const Figure& figure : figures) names.push_back(figure.name);
    const auto found = std::ranges::find(figures, task_.figure, &Figure::name);
    if (found == figures.end())
      return robotlink::failure("tune.figure",
                                "the runs have no figure '" + task_.figure + "'" +
                                    robotlink::suggestion(task_.figure, names) + "; there are " +
                                    fmt::format("{}", fmt::join(names, ", ")),
                                {}, {task_.figure});
    sum += found->value;
  }
  return sum / static_cast<double>(runs->size());
}

robotlink::Result<void> Tuning::checkThatParametersMatter() const {
  if (tried_.size() != kAlike) return {};
  const auto first = tried_.front().value;
  if (!first || !std::ranges::all_of(tried_, [&](const TunedPoint& one) { return one.value == first; }))
    return {};
  return robotlink::failure(
      "tune.alike",
      fmt::format("the first {} candidates all have {} of '{}', so the tuned parameters do not affect it; "
                  "does the scene's layout run the task, or is an option missing after --?",
                  kAlike, *first, task_.figure),
      {}, {task_.figure});
}

std::optional<double> Tuning::costAt(const std::vector<double>& point, const std::string& stage) {
  const auto [known, isNew] = known_.try_emplace(space_.numbersAt(point), tried_.size());
  if (isNew) {
    const auto value = evaluate(point);
    if (!value) error_ = value.error();
    if (error_ || Interrupt::noted()) {
      known_.erase(known);
      return std::nullopt;
    }
    tried_.push_back({point, *value, stage});
    if (const auto matters = checkThatParametersMatter(); !matters) {
      error_ = matters.error();
      return std::nullopt;
    }
    if (*value && (!best().value || isBetter(**value, *best().value))) best_ = tried_.size() - 1;
  }
  const auto& value = tried_[known->second].value;
  if (!value) return kNoResult;
  return task_.maximize ? -*value : *value;
}

robotlink::Result<bool> Tuning::search() {
  const Interrupt interrupt;
  const auto runs = runsOf("start", space_.start(), task_.execution.firstSeed, 1);
  if (!runs) return tl::unexpected(runs.error());
  if (const auto tried = task_.execution.tryOut(*runs); !tried) return tl::unexpected(tried.error());
  bool isWhole = costAt(space_.start(), "start").has_value();
  for (const Optimizer& stage : task_.stages) {
    if (!isWhole) break;
    const std::vector<double> start = best().point;
    stage.minimize(start, [&](const std::vector<double>& point) {
      const auto cost = costAt(point, stage.algorithm);
      isWhole = isWhole && cost.has_value();
      return cost;
    });
  }
  if (error_) return tl::unexpected(*error_);
  return isWhole;
}

robotlink::Result<Comparison> Tuning::validate() {
  const std::uint64_t firstSeed = task_.execution.firstSeed + static_cast<std::uint64_t>(task_.seeds);
  std::vector<PlannedRun> runs;
  for (const auto& [variant, point] : {std::pair("today", space_.start()), {"tuned", best().point}}) {
    const auto more = runsOf(variant, point, firstSeed, task_.heldOut);
    if (!more) return tl::unexpected(more.error());
    runs.insert(runs.end(), more->begin(), more->end());
  }
  const auto results = task_.execution.execute(runs);
  if (!results) return tl::unexpected(results.error());
  missing_ = results->missing;
  Comparison comparison;
  for (const auto& [run, printed] : results->results)
    comparison.add(run.variant, run.subject, figuresIn(printed));
  return comparison;
}

std::string Tuning::courseCsv() const {
  std::string csv = "candidate,stage," + csvField(task_.figure);
  for (const auto& axis : space_.axes()) csv += "," + csvField(axis.path);
  csv += "\n";
  for (std::size_t i = 0; i < tried_.size(); ++i) {
    csv += fmt::format("{},{},{}", i + 1, tried_[i].stage,
                       tried_[i].value ? fmt::format("{}", *tried_[i].value) : "");
    csv += fmt::format(",{}\n", fmt::join(space_.numbersAt(tried_[i].point), ","));
  }
  return csv;
}

std::vector<ReportTable> Tuning::tables() const {
  ReportTable parameters{"Parameters", {{"parameter", "from", "to", "today", "tuned"}}};
  const auto today = space_.numbersAt(space_.start()), tuned = space_.numbersAt(best().point);
  for (std::size_t i = 0; i < today.size(); ++i) {
    const auto& axis = space_.axes()[i];
    parameters.rows.push_back(
        {axis.path, fmt::format("{:.6g}", axis.low), fmt::format("{:.6g}", axis.high), today[i], tuned[i]});
  }
  ReportTable course{"Search", {{"algorithm", "candidates", "best " + task_.figure}}};
  std::optional<double> least;
  for (std::size_t i = 0; i < tried_.size(); ++i) {
    const TunedPoint& one = tried_[i];
    if (one.value && (!least || isBetter(*one.value, *least))) least = one.value;
    const bool isSame = course.rows.size() > 1 && course.rows.back().front() == one.stage;
    if (!isSame) course.rows.push_back({one.stage, "0", ""});
    auto& row = course.rows.back();
    row[1] = std::to_string(std::stoi(row[1]) + 1);
    row[2] = least ? fmt::format("{:.5g}", *least) : "-";
  }
  return {parameters, course};
}

}  // namespace app
