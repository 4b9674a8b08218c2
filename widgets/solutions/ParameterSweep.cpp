// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterSweep.h"

#include <QPointer>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/commands/CommandLine.h"
#include "widgets/solutions/ParameterEdits.h"

namespace widgets {
namespace {

using robotlink::failure;
using robotlink::Result;

constexpr std::size_t kMaxValues = 1000;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::string numberText(double number) {
  return QString::number(number, 'g', 9).toStdString();
}

}  // namespace

double ParameterSweep::Row::deviation() const {
  return count > 1 ? std::sqrt(squares / static_cast<double>(count - 1)) : 0;
}

/// Implements Welford, "Note on a method for calculating corrected sums of squares and products", 1962.
void ParameterSweep::Row::add(double figure) {
  minimum = count == 0 ? figure : std::min(minimum, figure);
  maximum = count == 0 ? figure : std::max(maximum, figure);
  ++count;
  const double before = figure - mean;
  mean += before / static_cast<double>(count);
  squares += before * (figure - mean);
}

ParameterSweep::ParameterSweep(robotlink::CommandTable& commands, robotlink::Session& session,
                               ParameterEdits& edits, QObject* parent)
    : QObject(parent), session_(session), edits_(edits), commands_(commands) {}

Result<std::vector<std::string>> ParameterSweep::valuesIn(const std::string& text) {
  const auto wrong = [&] {
    return failure(
        "sweep.values",
        "the values are a list, such as 1,2,5, or a range from:to:step, such as 0.1:0.5:0.1, with at "
        "most " +
            std::to_string(kMaxValues) + " values; not '" + text + "'",
        {}, {text});
  };
  const auto range = split(text, ':');
  if (range.size() < 2) {
    auto values = split(text, ',');
    if (values.empty() || values.size() > kMaxValues || std::ranges::find(values, "") != values.end())
      return wrong();
    return values;
  }
  std::vector<double> numbers;
  for (const std::string& part : range) {
    const auto number = robotlink::parsedNumber<double>(part);
    if (!number || !std::isfinite(*number)) return wrong();
    numbers.push_back(*number);
  }
  if (numbers.size() != 3 || numbers[2] == 0) return wrong();
  // A step that does not quite reach the end, because it was rounded, does.
  const double steps = std::floor((numbers[1] - numbers[0]) / numbers[2] + 1e-6);
  if (!(steps >= 0 && steps < static_cast<double>(kMaxValues))) return wrong();
  std::vector<std::string> values;
  for (int i = 0; i <= static_cast<int>(steps); ++i)
    values.push_back(numberText(numbers[0] + i * numbers[2]));
  return values;
}

std::string ParameterSweep::csv(const std::vector<Row>& rows) {
  std::string text = "value,count,mean,deviation,minimum,maximum\n";
  for (const Row& row : rows) {
    text += row.value + "," + std::to_string(row.count);
    for (const double number : {row.mean, row.deviation(), row.minimum, row.maximum})
      text += "," + (row.count > 0 ? numberText(number) : std::string());
    text += "\n";
  }
  return text;
}

Result<void> ParameterSweep::begin(Plan plan) {
  if (isRunning())
    return failure("sweep.running", "a sweep is already running; parameters.stop-sweep ends it");
  if (!(plan.seconds > 0)) return failure("sweep.seconds", "the time to measure has to be more than 0 s");
  if (plan.values.empty()) return failure("sweep.values", "there are no values to try");
  plan_ = std::move(plan);
  rows_.clear();
  failed_.reset();
  unreported_.reset();
  figure_ = std::make_unique<robotlink::ScriptCondition>(
      session_, plan_.figure, [this](double value, robotlink::Instant time) {
        // A tick may bring messages of more time than was requested.
        const bool isIn = robotlink::seconds(time - from_) <= plan_.seconds;
        if (state_ == State::kMeasuring && isIn) rows_.back().add(value);
      });
  if (const auto bound = figure_->look(); !bound) return tl::unexpected(bound.error());
  state_ = State::kAsking;
  edits_.requestValue(plan_.task, plan_.path, [guard = QPointer(this)](const Result<std::string>& value) {
    if (!guard || guard->state_ != State::kAsking) return;
    if (!value) return guard->end(value.error());
    guard->former_ = *value;
    guard->setNext();
  });
  if (isRunning()) return {};
  unreported_.reset();
  return tl::unexpected(*failed_);
}

void ParameterSweep::run(State state, const std::string& line) {
  state_ = state;
  run_ = std::make_unique<robotlink::ScriptRun>(robotlink::ScriptRun::Workbench{commands_, session_});
  run_->runLines({}, line);
}

void ParameterSweep::setNext() {
  const bool isLast = rows_.size() == plan_.values.size();
  if (!isLast) rows_.push_back({plan_.values[rows_.size()]});
  run(isLast ? State::kRestoring : State::kSetting,
      "robot.parameter " + robotlink::quotedWord(plan_.task) + " " + robotlink::quotedWord(plan_.path) + " " +
          robotlink::quotedWord(isLast ? former_ : rows_.back().value));
  Q_EMIT progressed();
}

void ParameterSweep::measure() {
  from_ = session_.timeline().newest();
  run(State::kMeasuring, "wait " + numberText(plan_.seconds));
}

void ParameterSweep::stop() {
  if (state_ == State::kAsking) return end(std::nullopt);
  if (state_ != State::kSetting && state_ != State::kMeasuring) return;
  rows_.pop_back();  // what was not measured to its end does not count
  plan_.values.resize(rows_.size());
  setNext();
}

void ParameterSweep::tick(robotlink::Instant now) {
  if (!isRunning() || state_ == State::kAsking) return;
  if (const auto bound = figure_->look(); !bound && state_ != State::kRestoring) {
    failed_ = bound.error();
    stop();
  }
  run_->tick(now);
  if (!run_->isIdle()) return;
  const auto wrong = run_->failed();
  if (wrong && state_ == State::kRestoring) return end(wrong);
  if (wrong) {
    failed_ = wrong;
    return stop();
  }
  if (state_ == State::kSetting) return measure();
  if (state_ == State::kRestoring) return end(failed_);
  if (rows_.back().count == 0) {
    failed_ = robotlink::Error{
        "sweep.nothing", "nothing was measured at " + rows_.back().value + ": " + figure_->values(), {}, {}};
    return stop();
  }
  setNext();
}

void ParameterSweep::end(std::optional<robotlink::Error> error) {
  state_ = State::kIdle;
  figure_.reset();
  run_.reset();
  if (!plan_.file.empty() && !rows_.empty()) {
    const auto written = robotlink::writeFileAtomically(plan_.file, csv(rows_));
    if (!written && !error) error = written.error();
  }
  failed_ = unreported_ = std::move(error);
  if (failed_) session_.reportRefusal("sweep of " + plan_.path, failed_->describe());
  Q_EMIT progressed();
}

Result<bool> ParameterSweep::working() {
  if (auto error = std::exchange(unreported_, std::nullopt)) return tl::unexpected(std::move(*error));
  return isRunning();
}

void attachSweepCommands(robotlink::CommandTable& commands, ParameterSweep& sweep) {
  if (commands.isAttached("parameters.sweep")) return;
  using Values = robotlink::CommandTable::Values;
  const auto gone = [] { return failure("robot.closed", "the window that swept parameters is closed"); };
  commands.attach("parameters.sweep", [guard = QPointer(&sweep), gone](const Values& values) -> Result<void> {
    if (!guard) return gone();
    const auto text = [&](std::size_t i) { return std::get<std::string>(values[i]); };
    auto list = ParameterSweep::valuesIn(text(2));
    if (!list) return tl::unexpected(list.error());
    return guard->begin({text(0), text(1), std::move(*list), text(3), std::get<double>(values[4]), text(5)});
  });
  commands.attach("parameters.stop-sweep", [guard = QPointer(&sweep), gone](const Values&) -> Result<void> {
    if (!guard) return gone();
    guard->stop();
    return {};
  });
}

}  // namespace widgets
