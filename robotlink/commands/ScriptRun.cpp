// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/ScriptRun.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/TextParts.h"
#include "robotlink/commands/ScriptCondition.h"
#include "robotlink/debugging/Streams.h"

namespace robotlink {
namespace {

/// How long a request may stay unanswered, and the session's time may stand still in `wait`: real time.
constexpr Duration kPatience = std::chrono::seconds(30);
constexpr std::size_t kMaxFile = 1U << 20U;

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) lines.emplace_back(takeLine(text));
  return lines;
}

std::string inSeconds(Duration duration) {
  std::string text = std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(duration).count());
  if (text.size() < 4) text.insert(0, 4 - text.size(), '0');
  text.insert(text.size() - 3, ".");
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

/// Moves the column of an error about the text of a line into the line.
Error inLine(Error error, const ScriptLine& line) {
  if (error.where.column > 0) error.where.column += line.column - 1;
  return error;
}

/// Why the time stands still and how it continues, for the end of a sentence; empty if nothing is paused.
std::string whyPaused(Session& session) {
  const StreamStore& store = session.store();
  const auto* replay = store.latestAs<robotcontrol::ReplayStatus>(streams::kReplay, Instant::max());
  if (replay != nullptr) return replay->playing() ? "" : ": the log is paused; log.play resumes it";
  const auto* simulation =
      store.latestAs<robotcontrol::SimulationStatus>(streams::kSimulation, Instant::max());
  if (simulation == nullptr || simulation->running()) return "";
  return ": the simulation is paused; simulation.start resumes it";
}

std::string withValues(std::string text, const std::string& values) {
  return values.empty() ? text : text + ": " + values;
}

}  // namespace

ScriptRun::ScriptRun(Workbench workbench) : workbench_(std::move(workbench)) {
  listener_ = workbench_.session.addListener({.request =
                                                  [this](const robotcontrol::Request& request) {
                                                    if (isListing_) unanswered_.insert(request.id());
                                                  },
                                              .result = [this](const auto& result) { take(result); },
                                              .handled =
                                                  [this](const auto& result) {
                                                    if (unanswered_.erase(result.id()) > 0)
                                                      isListing_ = false;
                                                  },
                                              .refusal =
                                                  [this](const std::string&, const std::string& reason) {
                                                    if (isListing_ && !refused_) refused_ = reason;
                                                  }});
}

/// Requests that the command sends in response to this answer belong to the command, too.
void ScriptRun::take(const robotcontrol::RequestResult& result) {
  if (!unanswered_.contains(result.id())) return;
  if (!result.accepted()) refused_ = result.reason();
  isListing_ = true;
}

ScriptRun::~ScriptRun() {
  workbench_.session.removeListener(listener_);
}

void ScriptRun::runFile(const std::filesystem::path& file) {
  failed_.reset();
  const auto text = readFile(file, kMaxFile);
  if (text) return push(file.string(), file.parent_path(), *text);
  failed_ = text.error();
  outcomes_.push_back({.name = file.string(), .failure = failed_->describe()});
}

void ScriptRun::runLines(const std::string& name, const std::string& lines) {
  failed_.reset();
  push(name, folder_, lines);
}

void ScriptRun::push(std::string name, std::filesystem::path folder, const std::string& text) {
  outcomes_.push_back({name});
  sources_.push_back({std::move(name), std::move(folder), linesOf(text), 0, outcomes_.size() - 1, {}});
}

Result<void> ScriptRun::include(const std::filesystem::path& file) {
  const auto path = (sources_.back().folder / file).lexically_normal();
  for (const Source& source : sources_) {
    std::error_code ignored;
    if (source.name != path.string() && !std::filesystem::equivalent(source.name, path, ignored)) continue;
    return failure("script.cycle", path.string() + " includes itself", {{}, 0, line_.column},
                   {path.string()});
  }
  const auto text = readFile(path, kMaxFile);
  if (!text) {
    const std::string why = text.error().text;
    return failure("script.include", "cannot include " + path.string() + ": " + why, {{}, 0, line_.column});
  }
  push(path.string(), path.parent_path(), *text);
  return {};
}

std::optional<std::string> ScriptRun::variable(const std::string& name) const {
  if (const auto found = variables_.find(name); found != variables_.end()) return found->second;
  if (name == "folder") {
    const std::string folder = (sources_.empty() ? folder_ : sources_.back().folder).string();
    return folder.empty() ? "." : folder;
  }
  const char* value = std::getenv(name.c_str());
  return value != nullptr ? std::optional<std::string>(value) : std::nullopt;
}

Result<std::string> ScriptRun::withValuesOfVariables(const std::string& line) const {
  return withVariables(line, [this](const std::string& name) { return variable(name); });
}

void ScriptRun::cancel() {
  sources_.clear();
  waits_ = Waits::kNothing;
  condition_.reset();
}

void ScriptRun::tick(Instant now) {
  // A command may run an event loop of its own, for a dialog, which calls this again.
  if (isListing_) return;
  while (!sources_.empty()) {
    if (!sources_.back().since) sources_.back().since = now;
    if (waits_ != Waits::kNothing) {
      const auto done = isDone(now);
      if (!done) return fail(done.error(), now);
      if (!*done) return;
      waits_ = Waits::kNothing;
      condition_.reset();
    }
    beginNext(now);
  }
}

void ScriptRun::beginNext(Instant now) {
  Source& source = sources_.back();
  if (source.next == source.lines.size()) return end(now);
  const std::string& text = source.lines[source.next++];
  if (auto begun = begin(text, now); !begun) fail(std::move(begun.error()), now);
}

void ScriptRun::end(Instant now) {
  outcomes_[sources_.back().outcome].seconds = seconds(now - *sources_.back().since);
  sources_.pop_back();
}

void ScriptRun::fail(Error error, Instant now) {
  const Source& source = sources_.back();
  // A position in another file, which the line reads, becomes a part of the error's text.
  if (!error.where.file.empty()) error = {error.id, error.describe(), error.arguments, {}};
  error.where.file = source.name;
  error.where.line = source.name.empty() ? 0 : static_cast<int>(source.next);
  failed_ = error;
  outcomes_[source.outcome].failure = error.describe();
  end(now);
  while (!sources_.empty()) {
    const Source& outer = sources_.back();
    outcomes_[outer.outcome].failure =
        outer.name + ":" + std::to_string(outer.next) + ": the included script failed: " + error.describe();
    end(now);
  }
  waits_ = Waits::kNothing;
  condition_.reset();
}

Result<void> ScriptRun::begin(const std::string& line, Instant now) {
  const auto text = withValuesOfVariables(line);
  if (!text) return tl::unexpected(text.error());
  auto read = readScriptLine(*text);
  if (!read) return tl::unexpected(read.error());
  line_ = std::move(*read);
  began_ = movedAt_ = now;
  switch (line_.kind) {
    case ScriptLine::Kind::kNothing:
      break;
    case ScriptLine::Kind::kCommand:
      return beginCommand();
    case ScriptLine::Kind::kWaitUntil:
      condition_ = std::make_unique<ScriptCondition>(workbench_.session, line_.text);
      waits_ = Waits::kCondition;
      break;
    case ScriptLine::Kind::kWait:
      timePassed_ = Duration(0);
      timeSeen_ = workbench_.session.timeline().newest();
      waits_ = Waits::kTime;
      break;
    case ScriptLine::Kind::kAssert:
      return check(line_.text);
    case ScriptLine::Kind::kPrint:
      return print(line_.text);
    case ScriptLine::Kind::kSet:
      variables_[line_.text] = line_.value;
      break;
    case ScriptLine::Kind::kInclude:
      return include(line_.text);
  }
  return {};
}

Result<void> ScriptRun::beginCommand() {
  unanswered_.clear();
  refused_.reset();
  // A platform that another user of the window opened before does not belong to this line.
  if (workbench_.opening) static_cast<void>(workbench_.opening());
  isListing_ = true;
  auto done = workbench_.commands.runLine(line_.text, folder_);
  isListing_ = false;
  if (!done) return tl::unexpected(inLine(std::move(done.error()), line_));
  waits_ = Waits::kCommand;
  return {};
}

Result<void> ScriptRun::check(const std::string& expression) const {
  ScriptCondition condition(workbench_.session, expression);
  const auto isTrue = condition.now();
  if (!isTrue) return tl::unexpected(inLine(isTrue.error(), line_));
  if (*isTrue) return {};
  return failure("script.assert", withValues("expected " + expression, condition.values()),
                 {{}, 0, line_.column});
}

Result<void> ScriptRun::print(const std::string& expression) const {
  const auto value = ScriptCondition(workbench_.session, expression).valueNow();
  if (!value) return tl::unexpected(inLine(value.error(), line_));
  if (output_) output_(*value);
  return {};
}

Result<bool> ScriptRun::isDone(Instant now) {
  switch (waits_) {
    case Waits::kNothing:
      return true;
    case Waits::kCommand:
      return isCommandDone(now);
    case Waits::kCondition:
      return isConditionMet(now);
    case Waits::kTime:
      return hasTimePassed(now);
  }
  return true;
}

Result<bool> ScriptRun::isCommandDone(Instant now) {
  if (refused_) return failure("script.refused", "refused: " + *refused_, {{}, 0, line_.column}, {*refused_});
  if (workbench_.opening) {
    const auto opening = workbench_.opening();
    if (!opening || *opening) return opening.map([](bool) { return false; });
  }
  if (unanswered_.empty()) return true;
  if (now - began_ < kPatience) return false;
  return failure("script.unanswered", "there was no answer for " + inSeconds(kPatience),
                 {{}, 0, line_.column});
}

Result<bool> ScriptRun::isConditionMet(Instant now) {
  const auto isTrue = condition_->look();
  if (!isTrue) return tl::unexpected(inLine(isTrue.error(), line_));
  const Duration limit = fromSeconds(std::min(line_.seconds, 1e9));
  if (*isTrue || now - began_ < limit) return *isTrue;
  return failure("script.timeout",
                 withValues("waited " + inSeconds(limit) + " for " + line_.text, condition_->values()),
                 {{}, 0, line_.column});
}

Result<bool> ScriptRun::hasTimePassed(Instant now) {
  const Instant time = workbench_.session.timeline().newest();
  // Steps back are a reset, or another place of a log, such as the begin of a loop.
  if (time > timeSeen_) timePassed_ += time - timeSeen_;
  if (time != timeSeen_) movedAt_ = now;
  timeSeen_ = time;
  if (seconds(timePassed_) >= line_.seconds) return true;
  if (now - movedAt_ < kPatience) return false;
  const std::string paused = whyPaused(workbench_.session);
  return failure("script.standstill", "expected " + inSeconds(fromSeconds(line_.seconds)) +
                                          " to pass, but time has stopped at " +
                                          inSeconds(workbench_.session.timeline().sinceOrigin(time)) +
                                          " for " + inSeconds(kPatience) + paused);
}

}  // namespace robotlink
