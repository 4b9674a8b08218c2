// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/replay/ReplayRun.h"

#include <algorithm>

#include "app/core/program/ColorTables.h"
#include "app/core/replay/ReplayRunParts.h"
#include "foxglove/Scene.pb.h"
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

/// The robot's name in a path; empty for paths without one.
std::string robotOf(const std::string& path) {
  const auto slash = path.find('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

/// Whether a message ends a frame, and so must come after the frame's other messages.
bool isFrameEnd(const StreamMessage& message) {
  return dynamic_cast<const robotcontrol::FrameInfo*>(message.value.get()) != nullptr;
}

/// Returns a queue with an offset added to all times; the same one if that is 0.
std::shared_ptr<const SharedDebugQueue> moved(const std::shared_ptr<const SharedDebugQueue>& queue,
                                              Duration offset) {
  if (offset == Duration::zero()) return queue;
  auto copy = std::make_shared<SharedDebugQueue>(*queue);
  for (SharedDebugMessage& message : copy->messages) {
    if (message.time) *message.time += offset;
  }
  return copy;
}

}  // namespace

ReplayRun::ReplayRun(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

ReplayRun::~ReplayRun() = default;

// ---- Making it

tl::expected<std::unique_ptr<ReplayRun>, Errors> ReplayRun::create(ReplayOptions options,
                                                                   Listeners listeners) {
  auto made = std::make_unique<Implementation>();
  made->options = std::move(options);
  made->listeners = std::move(listeners);
  if (Errors errors = made->open(); !errors.empty()) return tl::unexpected(std::move(errors));
  std::unique_ptr<ReplayRun> run(new ReplayRun(std::move(made)));
  run->implementation_->now = run->begin();
  run->implementation_->findStepProcess();
  return run;
}

Errors ReplayRun::Implementation::open() {
  if (options.logs.empty()) return {{"replay.no-log", "there is no log to play", {}, {}}};
  if (!options.colorTable.empty()) {
    auto table = readColorTable(options.colorTable);
    if (!table) return {table.error()};
    colorTable = std::move(*table);
  }
  bool hasWorld = false;
  for (std::size_t i = 0; i < options.logs.size(); ++i) {
    LogFile::Options opening;
    if (options.progress) {
      const double count = static_cast<double>(options.logs.size());
      opening.progress = [this, i, count](double share) {
        return options.progress((static_cast<double>(i) + share) / count);
      };
    }
    auto file = LogFile::open(options.logs[i].file, std::move(opening));
    if (!file) return {file.error()};
    options.logs[i].offset = offsetOf(options.logs[i], **file);
    auto& source = *sources.emplace_back(new Source{options.logs[i], ReplaySource(*file), !hasWorld, {}, {}});
    hasWorld = hasWorld || std::any_of((*file)->streams().begin(), (*file)->streams().end(),
                                       [](const auto& stream) { return stream.path == streams::kScene; });
    if (Errors errors = addRobots(source); !errors.empty()) return errors;
    source.reader.seek((*file)->begin());
    source.reader.onBrokenImage([this, &source](const StreamMessage& message, const std::string& why) {
      note(source, robotOf(message.path), message.time, foxglove::Log::ERROR,
           "an image on " + message.path + " could not be decoded: " + why);
    });
  }
  return checkChosenSolutions();
}

Duration ReplayRun::Implementation::offsetOf(const ReplayLog& log, const LogFile& file) const {
  if (log.offsetChosen || log.offset != Duration::zero() || sources.empty()) return log.offset;
  const Source& first = *sources.front();
  const Instant begin = first.onLine(first.reader.file().begin()),
                end = first.onLine(first.reader.file().end());
  const bool overlaps = file.begin() <= end && file.end() >= begin;
  return overlaps ? Duration::zero() : begin - file.begin();
}

Errors ReplayRun::Implementation::addRobots(Source& source) {
  for (const std::string& logName : source.reader.file().robots()) {
    const std::string name = freeName(logName);
    ReplayChoices choices;
    choices.layout = options.layout;
    ProgramOverrides overrides;
    if (const auto before = options.overrides.find(name); before != options.overrides.end())
      overrides = before->second;
    for (const auto& [task, solution] : options.solutions) overrides.chooseSolution(task, solution);
    if (colorTable) overrides.chooseColorTable(colorTable);
    choices.recomputeAll = options.recomputeAll;
    choices.publishAllPackages = options.publishAllPackages;
    for (const std::string& prefix : {std::string("*/"), name + "/"}) {
      for (const auto& [package, choice] : options.packages) {
        if (package.starts_with(prefix)) choices.packages[package.substr(prefix.size())] = choice;
      }
    }
    ReplayRobot::Listeners ears;
    ears.queue = [this, &source, name](const auto& queue) { hear(source, name, queue); };
    ears.trouble = [this, name](const robotlink::Process& process, const std::string& text) {
      if (listeners.trouble) listeners.trouble(name, process, "Process " + process.name() + " " + text);
    };
    auto& robot = *source.robots.emplace_back(
        std::make_unique<ReplayRobot>(source.reader.filePointer(), logName, name, std::move(choices),
                                      std::move(overrides), std::move(ears)));
    source.byLogName[logName] = &robot;
    if (Errors errors = robot.start(source.reader.file().begin()); !errors.empty()) return errors;
  }
  return {};
}

std::string ReplayRun::Implementation::freeName(const std::string& robot) const {
  std::string name = robot;
  for (int number = 2; findRobot(name) != nullptr; ++number) name = robot + "-" + std::to_string(number);
  return name;
}

// ---- Steps

bool ReplayRun::Implementation::step() {
  const auto time = nextTime();
  if (!time) return false;
  now = *time;
  for (const auto& source : sources) {
    const Instant logTime = source->inLog(now);
    if (source->reader.nextTime() != logTime) continue;
    const std::vector<StreamMessage> messages = source->reader.next();
    give(*source, logTime, messages);
    publish(*source, messages);
    for (const auto& robot : source->robots) robot->run();
  }
  return true;
}

void ReplayRun::Implementation::give(Source& source, Instant logTime,
                                     const std::vector<StreamMessage>& messages) {
  std::map<std::string, std::vector<StreamMessage>> byRobot;
  for (const StreamMessage& message : messages) byRobot[robotOf(message.path)].push_back(message);
  for (const auto& [logName, robot] : source.byLogName) robot->take(logTime, byRobot[logName]);
}

std::optional<StreamMessage> ReplayRun::Implementation::published(Source& source,
                                                                  const StreamMessage& message) const {
  const auto robot = source.byLogName.find(robotOf(message.path));
  if (robot == source.byLogName.end() && !source.publishesWorld) return std::nullopt;
  StreamMessage result = robot == source.byLogName.end() ? message : robot->second->published(message);
  result.time = source.onLine(result.time);
  return result;
}

void ReplayRun::Implementation::publish(Source& source, const std::vector<StreamMessage>& messages) {
  std::vector<StreamMessage> all = std::exchange(notes, {});
  for (const StreamMessage& message : messages) {
    if (auto shown = published(source, message)) all.push_back(std::move(*shown));
  }
  if (!all.empty() && listeners.logged) listeners.logged(std::move(all));
}

void ReplayRun::Implementation::hear(const Source& source, const std::string& robot,
                                     const std::shared_ptr<const SharedDebugQueue>& queue) {
  const auto shown = moved(queue, source.log.offset);
  if (!quiet) {
    if (listeners.queue) listeners.queue(robot, shown);
    return;
  }
  const auto reader =
      options.publishAllPackages ? robotlink::QueueReader::kRecorder : robotlink::QueueReader::kViews;
  auto taken = robotlink::messagesOf(robot, *shown, now, reader);
  for (StreamMessage& message : taken.messages) {
    if (hasHistory(message.path, message.value->GetDescriptor()->full_name())) {
      history.push_back(std::move(message));
    } else {
      newest[message.path] = std::move(message);
    }
  }
  for (const SharedDebugMessage& message : shown->messages) {
    if (message.as<robotcontrol::RequestResult>() == nullptr) continue;
    if (!answers) answers = std::make_shared<SharedDebugQueue>();
    answers->process = shown->process;
    answers->messages.push_back(message);
  }
}

void ReplayRun::Implementation::note(const Source& source, const std::string& robot, Instant logTime,
                                     int level, const std::string& text) {
  auto log = std::make_shared<foxglove::Log>();
  const Instant time = source.onLine(logTime);
  robotlink::assign(*log->mutable_timestamp(), time);
  log->set_level(static_cast<foxglove::Log::Level>(level));
  log->set_name("replay");
  log->set_message(text);
  notes.push_back({robot + "/" + streams::kLog, time, std::move(log)});
}

// ---- Jumps

Errors ReplayRun::Implementation::jump(Instant time) {
  quiet = true;
  newest.clear();
  history.clear();
  answers.reset();
  notes.clear();
  now = time;
  Errors errors;
  for (const auto& source : sources) {
    const Errors own = jump(*source, time);
    errors.insert(errors.end(), own.begin(), own.end());
  }
  quiet = false;
  std::vector<StreamMessage> messages = std::exchange(history, {});
  for (const auto& source : sources) {
    const Instant logTime = source->inLog(time);
    for (const StreamMessage& message : source->reader.past(logTime - options.preroll, logTime)) {
      if (auto shown = published(*source, message)) messages.push_back(std::move(*shown));
    }
  }
  for (auto& [path, message] : newest) messages.push_back(std::move(message));
  newest.clear();
  std::move(notes.begin(), notes.end(), std::back_inserter(messages));
  notes.clear();
  std::stable_sort(messages.begin(), messages.end(), [](const StreamMessage& a, const StreamMessage& b) {
    return std::pair(a.time, isFrameEnd(a)) < std::pair(b.time, isFrameEnd(b));
  });
  if (listeners.logged) listeners.logged(std::move(messages));
  if (answers && listeners.queue) listeners.queue(firstRobot(), std::exchange(answers, nullptr));
  return errors;
}

// Results are matched by the id of their request, so any robot will do.
std::string ReplayRun::Implementation::firstRobot() const {
  for (const auto& source : sources) {
    if (!source->robots.empty()) return source->robots.front()->name();
  }
  return {};
}

Errors ReplayRun::Implementation::jump(Source& source, Instant time) {
  const Instant target = source.inLog(time);
  const Instant begin = source.reader.file().begin();
  const Instant from = std::max(begin, std::min(target, source.reader.file().end()) - options.preroll);
  Errors errors;
  for (const auto& robot : source.robots) {
    const Errors own = robot->start(from);
    errors.insert(errors.end(), own.begin(), own.end());
    notes.push_back({robot->name() + "/" + streams::kProgram, time, robot->ownSetup()});
    for (const auto* texts : {&robot->setup().notes, &robot->plan().notes}) {
      for (const std::string& text : *texts)
        note(source, robot->name(), target, foxglove::Log::WARNING, text);
    }
  }
  runQuietly(source, from, target);
  source.reader.seek(target + Duration(1));
  return errors;
}

void ReplayRun::Implementation::runQuietly(Source& source, Instant from, Instant to) {
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

// ---- Requests

Errors ReplayRun::Implementation::changeChoices(
    const std::function<void(const std::string&, ReplayChoices&)>& change) {
  std::vector<std::function<void()>> takeBack;
  Errors errors;
  for (const auto& source : sources) {
    for (const auto& robot : source->robots) {
      ReplayChoices choices = robot->choices();
      change(robot->name(), choices);
      const Instant logTime = source->inLog(now);
      const auto undo = [&changed = *robot, before = robot->choices(), logTime] {
        (void)changed.start(logTime, before);
      };
      errors = robot->start(logTime, std::move(choices));
      // Nothing has changed for this robot.
      if (!errors.empty()) break;
      takeBack.emplace_back(undo);
      robot->differences().clear();
    }
    if (!errors.empty()) break;
  }
  if (!errors.empty()) {
    for (const auto& undo : takeBack) undo();
  }
  const Errors jumped = jump(now);
  errors.insert(errors.end(), jumped.begin(), jumped.end());
  return errors;
}

Errors ReplayRun::choosePackages(const std::map<std::string, ControlReplay::PackageSource>& packages) {
  Implementation& self = *implementation_;
  for (const auto& [package, source] : packages) {
    if (self.findRobot(robotOf(package)) != nullptr) continue;
    return {{"replay.no-robot",
             "there is no robot " + robotOf(package) + " in the logs",
             {robotOf(package)},
             {}}};
  }
  return self.changeChoices([&](const std::string& robot, ReplayChoices& choices) {
    for (const auto& [package, source] : packages) {
      if (package.starts_with(robot + "/")) choices.packages[package.substr(robot.size() + 1)] = source;
    }
  });
}

Errors ReplayRun::setLayout(const std::filesystem::path& file) {
  Errors errors = implementation_->changeChoices(
      [&](const std::string&, ReplayChoices& choices) { choices.layout = file; });
  if (errors.empty()) implementation_->options.layout = file;
  return errors;
}

void ReplayRun::setOffset(const std::filesystem::path& log, Duration offset) {
  for (const auto& source : implementation_->sources) {
    if (source->log.file == log) source->log = {log, offset, true};
  }
  for (ReplayLog& known : implementation_->options.logs) {
    if (known.file == log) known = {log, offset, true};
  }
  (void)implementation_->jump(std::clamp(now(), begin(), end()));
}

robotlink::Result<void> ReplayRun::request(const robotcontrol::Request& request) {
  ReplayRobot* robot = implementation_->findRobot(request.robot());
  if (robot == nullptr) {
    return robotlink::failure("request.no-robot", "there is no robot " + request.robot() + " in the logs", {},
                              {request.robot()});
  }
  return robot->request(request);
}

std::vector<ReplayRun::Answers> ReplayRun::answersToCome() {
  std::vector<Answers> all;
  for (const auto& source : implementation_->sources) {
    for (const auto& robot : source->robots) {
      if (const auto queue = robot->answersToCome())
        all.emplace_back(robot->name(), moved(queue, source->log.offset));
    }
  }
  return all;
}

std::map<std::string, ProgramOverrides> ReplayRun::overrides() const {
  std::map<std::string, ProgramOverrides> all;
  for (const auto& source : implementation_->sources) {
    for (const auto& robot : source->robots) all[robot->name()] = robot->overrides();
  }
  return all;
}

std::vector<std::string> ReplayRun::lostChoices() const {
  std::vector<std::string> all;
  for (const auto& source : implementation_->sources) {
    for (const auto& robot : source->robots) {
      for (std::string& lost : robot->lostChoices()) all.push_back(std::move(lost));
    }
  }
  return all;
}

bool ReplayRun::step() {
  return implementation_->step();
}

Errors ReplayRun::jump(Instant time) {
  return implementation_->jump(std::clamp(time, begin(), end()));
}

}  // namespace app
