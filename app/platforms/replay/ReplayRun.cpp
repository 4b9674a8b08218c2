// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayRun.h"

#include <algorithm>

#include "app/core/program/ColorTables.h"
#include "app/core/program/SolutionChoices.h"
#include "foxglove/Robot.pb.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/QueueMessages.h"

namespace app {

namespace streams = robotlink::streams;

using logplayer::LogFile;
using robotcontrol::ControlReplay;
using robotlink::Duration;
using robotlink::Errors;
using robotlink::Instant;
using robotlink::SharedDebugMessage;
using robotlink::SharedDebugQueue;
using robotlink::StreamMessage;

namespace {

/// Whether a message ends a frame, and so must come after the frame's other messages.
bool isFrameEnd(const StreamMessage& message) {
  return dynamic_cast<const robotcontrol::FrameInfo*>(message.value.get()) != nullptr;
}

/// Returns a message of a log as it is published; nothing if it is not.
std::optional<StreamMessage> published(const ReplayLogs::Source& source, const StreamMessage& message) {
  const auto robot = source.byLogName.find(robotlink::streams::robotOf(message.path));
  if (robot == source.byLogName.end() && !source.publishesWorld) return std::nullopt;
  StreamMessage result = robot == source.byLogName.end() ? message : robot->second->published(message);
  result.time = source.onLine(result.time);
  return result;
}

/// Whether a message comes before another one that is published with it.
bool isBefore(const StreamMessage& a, const StreamMessage& b) {
  return std::pair(a.time, isFrameEnd(a)) < std::pair(b.time, isFrameEnd(b));
}

}  // namespace

ReplayRun::ReplayRun(ReplayOptions options, Listeners listeners)
    : options_(std::move(options)), listeners_(std::move(listeners)) {}

ReplayRun::~ReplayRun() = default;

void ReplayRun::stop() {
  for (ReplayRobot* robot : logs_.robots()) robot->end();
}

bool ReplayRun::hasEnded() const {
  return std::ranges::all_of(logs_.robots(), [](const ReplayRobot* robot) { return robot->hasEnded(); });
}

// ---- Making it

tl::expected<std::unique_ptr<ReplayRun>, Errors> ReplayRun::create(ReplayOptions options,
                                                                   Listeners listeners) {
  std::unique_ptr<ReplayRun> run(new ReplayRun(std::move(options), std::move(listeners)));
  if (Errors errors = run->open(); !errors.empty()) return tl::unexpected(std::move(errors));
  run->now_ = run->begin();
  run->stepProcess_ = run->logs_.stepProcess();
  return run;
}

Errors ReplayRun::open() {
  if (options_.logs.empty()) return {{"replay.no-log", "there is no log to play", {}, {}}};
  if (!options_.colorTable.empty()) {
    auto table = readColorTable(options_.colorTable);
    if (!table) return {table.error()};
    colorTable_ = std::move(*table);
  }
  for (std::size_t i = 0; i < options_.logs.size(); ++i) {
    LogFile::Options opening;
    if (options_.progress) {
      const double count = static_cast<double>(options_.logs.size());
      opening.progress = [this, i, count](double share) {
        return options_.progress((static_cast<double>(i) + share) / count);
      };
    }
    const auto& opened = options_.logs[i].opened;
    auto file = opened ? opened : LogFile::open(options_.logs[i].file, std::move(opening));
    if (!file) return {file.error()};
    options_.logs[i].offset = offsetOf(options_.logs[i], **file);
    auto& source = logs_.add(options_.logs[i], *file);
    if (Errors errors = addRobots(source); !errors.empty()) return errors;
    source.reader.seek((*file)->begin());
    source.reader.onBrokenImage([this, &source](const StreamMessage& message, const std::string& why) {
      const auto robot = source.byLogName.find(robotlink::streams::robotOf(message.path));
      note(
          source,
          robot == source.byLogName.end() ? robotlink::streams::robotOf(message.path) : robot->second->name(),
          message.time, foxglove::Log::ERROR,
          "an image on " + message.path + " could not be decoded: " + why);
    });
  }
  return checkChosenSolutions();
}

Duration ReplayRun::offsetOf(const ReplayLog& log, const LogFile& file) const {
  if (log.offsetChosen || log.offset != Duration::zero() || logs_.sources().empty()) return log.offset;
  const ReplayLogs::Source& first = *logs_.sources().front();
  const Instant begin = first.onLine(first.reader.file().begin()),
                end = first.onLine(first.reader.file().end());
  const bool overlaps = file.begin() <= end && file.end() >= begin;
  return overlaps ? Duration::zero() : begin - file.begin();
}

Errors ReplayRun::addRobots(ReplayLogs::Source& source) {
  for (const std::string& logName : source.reader.file().robots()) {
    const std::string name = logs_.freeName(logName);
    RobotHost::Listeners listeners{
        [this, &source](const std::string& robot, const auto& queue) { hear(source, robot, queue); },
        listeners_.trouble,
        {},
        {},
        [this, &source](const std::string& robot, Instant time, const auto& status) {
          if (listeners_.hosting) listeners_.hosting(robot, source.onLine(time), status);
        }};
    auto& robot = *source.robots.emplace_back(
        std::make_unique<ReplayRobot>(source.reader.filePointer(), logName, name, choicesOf(name),
                                      overridesOf(name), std::move(listeners)));
    source.byLogName[logName] = &robot;
    auto start = robot.prepare(source.reader.file().begin(), robot.choices());
    if (!start) return start.error();
    robot.begin(std::move(*start));
  }
  return {};
}

ReplayChoices ReplayRun::choicesOf(const std::string& robot) const {
  ReplayChoices choices;
  choices.layout = options_.layout;
  choices.recomputeAll = options_.recomputeAll;
  choices.publishAllPackages = options_.publishAllPackages;
  choices.hosting = {options_.patience, options_.hosting.isOwn(robot), options_.own};
  for (const std::string& prefix : {std::string("*/"), robot + "/"}) {
    for (const auto& [package, choice] : options_.packages) {
      if (package.starts_with(prefix)) choices.packages[package.substr(prefix.size())] = choice;
    }
  }
  return choices;
}

ProgramOverrides ReplayRun::overridesOf(const std::string& robot) const {
  const auto before = options_.overrides.find(robot);
  ProgramOverrides overrides = before != options_.overrides.end() ? before->second : ProgramOverrides();
  for (const auto& [task, solution] : options_.solutions) overrides.chooseSolution(task, solution);
  if (colorTable_) overrides.chooseColorTable(colorTable_);
  return overrides;
}

Errors ReplayRun::checkChosenSolutions() const {
  if (options_.solutions.empty()) return {};
  std::vector<const robotlink::Layout*> layouts;
  for (const ReplayRobot* robot : logs_.robots()) layouts.push_back(&robot->setup().layout);
  Errors errors = checkSolutions(options_.solutions, robotlink::registeredTasks(), layouts);
  if (!errors.empty()) return errors;
  for (const ReplayRobot* robot : logs_.robots()) {
    for (const auto& [task, solution] : options_.solutions) {
      const std::string why = robot->whyNotDoneBy(task, solution);
      if (why.empty()) continue;
      errors.push_back({"replay.solution",
                        robot->name() + ": task " + task + " cannot be done by " + solution + ": " + why,
                        {robot->name(), task, solution},
                        {}});
    }
  }
  return errors;
}

// ---- Steps

bool ReplayRun::step() {
  const auto time = nextTime();
  if (!time) return false;
  now_ = *time;
  for (const auto& source : logs_.sources()) {
    const Instant logTime = source->inLog(now_);
    if (source->reader.nextTime() != logTime) continue;
    const std::vector<StreamMessage> messages = source->reader.next();
    give(*source, logTime, messages);
    publish(*source, messages);
    for (const auto& robot : source->robots) robot->run();
  }
  return true;
}

void ReplayRun::give(ReplayLogs::Source& source, Instant logTime,
                     const std::vector<StreamMessage>& messages) {
  std::map<std::string, std::vector<StreamMessage>> byRobot;
  for (const StreamMessage& message : messages)
    byRobot[robotlink::streams::robotOf(message.path)].push_back(message);
  for (const auto& [logName, robot] : source.byLogName) robot->take(logTime, byRobot[logName]);
}

void ReplayRun::publish(ReplayLogs::Source& source, const std::vector<StreamMessage>& messages) {
  std::vector<StreamMessage> all = std::exchange(notes_, {});
  for (const StreamMessage& message : messages) {
    if (auto shown = published(source, message)) all.push_back(std::move(*shown));
  }
  if (!all.empty() && listeners_.logged) listeners_.logged(std::move(all));
}

void ReplayRun::hear(const ReplayLogs::Source& source, const std::string& robot,
                     const std::shared_ptr<const SharedDebugQueue>& queue) {
  const auto shown = onLine(queue, source.log.offset);
  if (!quiet_) {
    if (listeners_.queue) listeners_.queue(robot, shown);
    return;
  }
  const auto reader =
      options_.publishAllPackages ? robotlink::QueueReader::kRecorder : robotlink::QueueReader::kViews;
  auto taken = robotlink::messagesOf(robot, *shown, now_, reader);
  for (StreamMessage& message : taken.messages) {
    if (hasHistory(message.path, message.value->GetDescriptor()->full_name())) {
      history_.push_back(std::move(message));
    } else {
      newest_[message.path] = std::move(message);
    }
  }
  for (const SharedDebugMessage& message : shown->messages) {
    if (message.as<robotcontrol::RequestResult>() == nullptr) continue;
    if (!answers_) answers_ = std::make_shared<SharedDebugQueue>();
    answers_->process = shown->process;
    answers_->messages.push_back(message);
  }
}

std::shared_ptr<const SharedDebugQueue> ReplayRun::onLine(
    const std::shared_ptr<const SharedDebugQueue>& queue, Duration offset) {
  if (offset == Duration::zero()) return queue;
  auto copy = std::make_shared<SharedDebugQueue>(*queue);
  for (SharedDebugMessage& message : copy->messages) {
    if (message.time) *message.time += offset;
  }
  return copy;
}

void ReplayRun::note(const ReplayLogs::Source& source, const std::string& robot, Instant logTime, int level,
                     const std::string& text) {
  auto log = std::make_shared<foxglove::Log>();
  const Instant time = source.onLine(logTime);
  robotlink::assign(*log->mutable_timestamp(), time);
  log->set_level(static_cast<foxglove::Log::Level>(level));
  log->set_name("replay");
  log->set_message(text);
  notes_.push_back({robot + "/" + streams::kLog, time, std::move(log)});
}

// ---- Jumps

Instant ReplayRun::startOf(const ReplayLogs::Source& source, Instant time) const {
  const logplayer::LogFile& file = source.reader.file();
  return std::max(file.begin(), std::min(source.inLog(time), file.end()) - options_.preroll);
}

Errors ReplayRun::jump(Instant time, const Change& change) {
  std::vector<std::pair<ReplayRobot*, ReplayRobot::Start>> starts;
  Errors errors;
  for (const auto& source : logs_.sources()) {
    for (const auto& robot : source->robots) {
      ReplayChoices choices = robot->choices();
      if (change) change(robot->name(), choices);
      // If nothing is computed, nothing has to settle, and the program is that of the aim.
      const bool computes = change || robot->computes();
      auto start =
          robot->prepare(computes ? startOf(*source, time) : source->inLog(time), std::move(choices));
      if (start) {
        starts.emplace_back(robot.get(), std::move(*start));
      } else {
        errors.insert(errors.end(), start.error().begin(), start.error().end());
      }
    }
  }
  if (!errors.empty()) return errors;
  now_ = time;
  newest_.clear();
  history_.clear();
  notes_.clear();
  answers_.reset();
  quiet_ = true;
  for (auto& [robot, start] : starts) {
    robot->begin(std::move(start));
    if (change) robot->differences().clear();
  }
  for (const auto& source : logs_.sources()) {
    const Instant target = source->inLog(time);
    for (const auto& robot : source->robots) noteStart(*source, *robot, time);
    runQuietly(*source, startOf(*source, time), target);
    source->reader.seek(target + Duration(1));
  }
  quiet_ = false;
  publishCollected();
  return {};
}

void ReplayRun::noteStart(const ReplayLogs::Source& source, const ReplayRobot& robot, Instant time) {
  notes_.push_back({robot.name() + "/" + streams::kProgram, time, robot.ownSetup()});
  for (const auto* texts : {&robot.setup().notes, &robot.plan().notes}) {
    for (const std::string& text : *texts)
      note(source, robot.name(), source.inLog(time), foxglove::Log::WARNING, text);
  }
}

void ReplayRun::publishCollected() {
  std::vector<StreamMessage> messages = std::exchange(history_, {});
  for (const auto& source : logs_.sources()) {
    const Instant logTime = source->inLog(now_);
    for (const StreamMessage& message : source->reader.past(logTime - options_.preroll, logTime)) {
      if (auto shown = published(*source, message)) messages.push_back(std::move(*shown));
    }
  }
  for (auto& [path, message] : newest_) messages.push_back(std::move(message));
  newest_.clear();
  std::move(notes_.begin(), notes_.end(), std::back_inserter(messages));
  notes_.clear();
  std::ranges::stable_sort(messages, isBefore);
  if (listeners_.logged) listeners_.logged(std::move(messages));
  if (!answers_ || !listeners_.queue) return;
  // Results are matched by the id of their request, so any robot will do.
  const auto robots = logs_.robots();
  listeners_.queue(robots.empty() ? std::string() : robots.front()->name(), std::exchange(answers_, nullptr));
}

void ReplayRun::runQuietly(ReplayLogs::Source& source, Instant from, Instant to) {
  std::vector<std::string> needed;
  bool computes = false;
  for (const auto& robot : source.robots) {
    const auto own = robot->neededStreams();
    needed.insert(needed.end(), own.begin(), own.end());
    computes = computes || robot->computes();
  }
  if (needed.empty() || !computes) {
    // If nothing is recomputed, only the present instant matters, for what the program says about itself.
    for (const auto& robot : source.robots) {
      robot->take(to, {});
      robot->run();
    }
    return;
  }
  source.reader.seek(from, needed);
  for (auto next = source.reader.nextTime(); next && *next <= to;) {
    const std::vector<StreamMessage> messages = source.reader.next();
    const Instant logTime = *next;
    next = source.reader.nextTime();
    const bool last = !next || *next > to;
    for (const auto& robot : source.robots) robot->countDifferences(last);
    give(source, logTime, messages);
    for (const auto& robot : source.robots) robot->run();
  }
}

Errors ReplayRun::jump(Instant time) {
  return jump(std::clamp(time, begin(), end()), {});
}

// ---- What the user chose

std::map<std::string, ProgramOverrides> ReplayRun::overrides() const {
  std::map<std::string, ProgramOverrides> all;
  for (const ReplayRobot* robot : logs_.robots()) all[robot->name()] = robot->host().overrides();
  return all;
}

std::vector<std::string> ReplayRun::lostChoices() const {
  std::vector<std::string> all;
  for (const ReplayRobot* robot : logs_.robots()) {
    for (std::string& lost : robot->lostChoices()) all.push_back(std::move(lost));
  }
  return all;
}

std::vector<std::string> ReplayRun::unusedSolutions() const {
  std::vector<std::string> sentences;
  for (const ReplayRobot* robot : logs_.robots()) {
    for (const auto& absence : robot->plan().layout.absent) {
      const auto chosen = options_.solutions.find(absence.task);
      if (chosen == options_.solutions.end()) continue;
      sentences.push_back(robot->name() + ": task " + absence.task + " does not run, so that its solution " +
                          chosen->second + " changes nothing; " + absence.reason);
    }
  }
  return sentences;
}

// ---- Finding and describing

std::optional<Instant> ReplayRun::frameTime(const std::string& process, int count) const {
  return messageTime(ReplayLogs::framesOf(process), count);
}

std::optional<Instant> ReplayRun::messageTime(const std::string& stream, int count) const {
  return logs_.countedTime(stream, count, now_);
}

bool ReplayRun::setStepProcess(const std::string& process) {
  if (!firstTime(ReplayLogs::framesOf(process))) return false;
  stepProcess_ = process;
  return true;
}

std::vector<std::string> ReplayRun::robots() const {
  std::vector<std::string> names;
  for (const ReplayRobot* robot : logs_.robots()) names.push_back(robot->name());
  return names;
}

std::shared_ptr<const robotlink::RobotDescription> ReplayRun::description(const std::string& name) const {
  const ReplayRobot* robot = logs_.find(name);
  return robot != nullptr ? robot->host().robot().description : nullptr;
}

std::shared_ptr<const robotlink::FieldDescription> ReplayRun::field() const {
  const auto robots = logs_.robots();
  return robots.empty() ? nullptr : robots.front()->host().robot().field;
}

void ReplayRun::describe(robotcontrol::ReplayStatus& status) const {
  status.set_time(now_.time_since_epoch().count());
  status.set_step_process(stepProcess_);
  logs_.describe(status);
  logs_.describeFrame(stepProcess_, now_, status);
}

}  // namespace app
