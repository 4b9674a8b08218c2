// SPDX-License-Identifier: GPL-3.0-or-later
// How a ReplayRun finds instants, streams and frames in its logs, and describes itself.
#include <algorithm>

#include "app/core/program/SolutionChoices.h"
#include "app/core/replay/ReplayRunParts.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/Streams.h"

namespace app {

namespace streams = robotlink::streams;

using robotcontrol::FrameInfo;
using robotcontrol::ReplayStatus;
using robotlink::Errors;
using robotlink::Instant;

namespace {

std::int64_t nanoseconds(Instant time) {
  return time.time_since_epoch().count();
}

std::uint64_t numberOf(const std::optional<robotlink::StreamMessage>& message) {
  const auto* info = message ? dynamic_cast<const FrameInfo*>(message->value.get()) : nullptr;
  return info != nullptr ? info->number() : 0;
}

/// Whether a process waits for images.
bool blocksOnImages(const robotlink::Layout::Process& process) {
  return std::any_of(process.blocking.begin(), process.blocking.end(),
                     [](const auto& input) { return input.package == robotlink::kCameraImage.name; });
}

}  // namespace

// ---- Time

Instant ReplayRun::now() const {
  return implementation_->now;
}

Instant ReplayRun::begin() const {
  Instant earliest = Instant::max();
  for (const auto& source : implementation_->sources) {
    earliest = std::min(earliest, source->onLine(source->reader.file().begin()));
  }
  return earliest;
}

Instant ReplayRun::end() const {
  Instant latest = Instant::min();
  for (const auto& source : implementation_->sources) {
    latest = std::max(latest, source->onLine(source->reader.file().end()));
  }
  return latest;
}

std::optional<Instant> ReplayRun::Implementation::nextTime() const {
  std::optional<Instant> next;
  for (const auto& source : sources) {
    const auto own = source->reader.nextTime();
    if (own && (!next || source->onLine(*own) < *next)) next = source->onLine(*own);
  }
  return next;
}

std::optional<Instant> ReplayRun::nextTime() const {
  return implementation_->nextTime();
}

// ---- Robots, streams, frames

ReplayRobot* ReplayRun::Implementation::findRobot(const std::string& name) const {
  for (const auto& source : sources) {
    for (const auto& robot : source->robots) {
      if (robot->name() == name) return robot.get();
    }
  }
  return nullptr;
}

ReplayRun::Implementation::Place ReplayRun::Implementation::placeOf(const std::string& stream) const {
  for (const auto& source : sources) {
    for (const auto& [logName, robot] : source->byLogName) {
      if (!stream.starts_with(robot->name() + "/")) continue;
      std::string path = stream.substr(robot->name().size() + 1);
      if (path.starts_with(streams::kLogged)) path.erase(0, std::string_view(streams::kLogged).size());
      return {source.get(), robot, logName + "/" + path};
    }
  }
  // Streams that belong to no robot are looked for in the first log only.
  const bool ofWorld = stream.find('/') == std::string::npos && !sources.empty();
  return ofWorld ? Place{sources.front().get(), nullptr, stream} : Place{};
}

std::string ReplayRun::Implementation::framesOf(const std::string& process) {
  const auto slash = process.find('/');
  if (slash == std::string::npos) return {};
  return process.substr(0, slash + 1) + streams::kFrames + process.substr(slash + 1);
}

std::optional<Instant> ReplayRun::Implementation::countedTime(const std::string& stream, int count) const {
  const Place place = placeOf(stream);
  if (place.source == nullptr) return std::nullopt;
  const auto& times = place.source->reader.times(place.stream);
  if (times.empty()) return std::nullopt;
  // Several messages at one instant count as one step.
  std::vector<Instant> instants;
  instants.reserve(times.size());
  std::unique_copy(times.begin(), times.end(), std::back_inserter(instants));
  const auto after = std::upper_bound(instants.begin(), instants.end(), place.source->inLog(now));
  // -1 before the first instant.
  const auto current = (after - instants.begin()) - 1;
  const auto last = static_cast<std::ptrdiff_t>(instants.size()) - 1;
  const auto wanted = std::clamp<std::ptrdiff_t>(current + count, 0, last);
  return place.source->onLine(instants[static_cast<std::size_t>(wanted)]);
}

std::optional<Instant> ReplayRun::frameTime(const std::string& process, int count) const {
  return implementation_->countedTime(Implementation::framesOf(process), count);
}

std::optional<Instant> ReplayRun::messageTime(const std::string& stream, int count) const {
  return implementation_->countedTime(stream, count);
}

// The numbers of frames grow with time, so a binary search has to read only few of them.
std::optional<Instant> ReplayRun::Implementation::timeOfFrame(const std::string& process,
                                                              std::uint64_t frame) const {
  const Place place = placeOf(framesOf(process));
  if (place.source == nullptr) return std::nullopt;
  const auto& times = place.source->reader.times(place.stream);
  const auto found = std::partition_point(times.begin(), times.end(), [&](Instant time) {
    return numberOf(place.source->reader.latest(place.stream, time)) < frame;
  });
  if (found == times.end() || numberOf(place.source->reader.latest(place.stream, *found)) != frame)
    return std::nullopt;
  return place.source->onLine(*found);
}

std::optional<Instant> ReplayRun::timeOfFrame(const std::string& process, std::uint64_t frame) const {
  return implementation_->timeOfFrame(process, frame);
}

void ReplayRun::Implementation::findStepProcess() {
  // The best candidate is the last one.
  std::vector<std::string> best;
  for (const auto& source : sources) {
    for (const auto& [logName, robot] : source->byLogName) {
      const std::string prefix = logName + "/" + streams::kFrames;
      // In the same order, for this robot.
      std::vector<std::string> names;
      for (const auto& stream : source->reader.file().streams()) {
        if (!stream.path.starts_with(prefix)) continue;
        const std::string process = stream.path.substr(prefix.size());
        const auto& all = robot->setup().layout.processes;
        const auto known =
            std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == process; });
        const bool takesImages = known != all.end() && blocksOnImages(*known);
        names.insert(takesImages ? names.end() : names.begin(), robot->name() + "/" + process);
      }
      best.insert(best.begin(), names.begin(), names.end());
    }
  }
  if (!best.empty()) stepProcess = best.back();
}

bool ReplayRun::setStepProcess(const std::string& process) {
  if (!frameTime(process, 0)) return false;
  implementation_->stepProcess = process;
  return true;
}

const std::string& ReplayRun::stepProcess() const {
  return implementation_->stepProcess;
}

// ---- Chosen solutions

Errors ReplayRun::Implementation::checkChosenSolutions() const {
  if (options.solutions.empty()) return {};
  std::vector<const robotlink::Layout*> layouts;
  for (const auto& source : sources) {
    for (const auto& robot : source->robots) layouts.push_back(&robot->setup().layout);
  }
  Errors errors = checkSolutions(options.solutions, robotlink::registeredTasks(), layouts);
  if (!errors.empty()) return errors;
  for (const auto& source : sources) {
    for (const auto& robot : source->robots) {
      for (const auto& [task, solution] : options.solutions) {
        const std::string why = robot->whyNotDoneBy(task, solution);
        if (why.empty()) continue;
        errors.push_back({"replay.solution",
                          robot->name() + ": task " + task + " cannot be done by " + solution + ": " + why,
                          {robot->name(), task, solution},
                          {}});
      }
    }
  }
  return errors;
}

std::vector<std::string> ReplayRun::unusedSolutions() const {
  std::vector<std::string> sentences;
  for (const auto& source : implementation_->sources) {
    for (const auto& robot : source->robots) {
      for (const auto& absence : robot->plan().layout.absent) {
        const auto chosen = implementation_->options.solutions.find(absence.task);
        if (chosen == implementation_->options.solutions.end()) continue;
        sentences.push_back(robot->name() + ": task " + absence.task +
                            " does not run, so that its solution " + chosen->second + " changes nothing; " +
                            absence.reason);
      }
    }
  }
  return sentences;
}

// ---- Description

const ReplayOptions& ReplayRun::options() const {
  return implementation_->options;
}

std::vector<std::string> ReplayRun::robots() const {
  std::vector<std::string> names;
  for (const auto& source : implementation_->sources) {
    for (const auto& robot : source->robots) names.push_back(robot->name());
  }
  return names;
}

std::shared_ptr<const robotlink::RobotDescription> ReplayRun::description(const std::string& name) const {
  const ReplayRobot* robot = implementation_->findRobot(name);
  return robot != nullptr ? robot->setup().description : nullptr;
}

std::shared_ptr<const robotlink::FieldDescription> ReplayRun::field() const {
  for (const auto& source : implementation_->sources) {
    if (!source->robots.empty()) return source->robots.front()->setup().field;
  }
  return nullptr;
}

void ReplayRun::describe(ReplayStatus& status) const {
  status.set_time(nanoseconds(now()));
  status.set_begin(nanoseconds(begin()));
  status.set_end(nanoseconds(end()));
  implementation_->describeLogs(status);
  implementation_->describePackages(status);
  implementation_->describeFrame(status);
}

void ReplayRun::Implementation::describeLogs(ReplayStatus& status) const {
  for (const auto& source : sources) {
    const auto& file = source->reader.file();
    auto& log = *status.add_logs();
    log.set_path(file.path().string());
    log.set_offset(source->log.offset.count());
    log.set_read_only(file.readOnly());
    log.set_damage(file.damageText());
    log.set_begin(nanoseconds(source->onLine(file.begin())));
    log.set_end(nanoseconds(source->onLine(file.end())));
    for (const auto& [logName, robot] : source->byLogName) {
      log.add_robots(robot->name());
      const std::string prefix = logName + "/" + streams::kFrames;
      for (const auto& stream : file.streams()) {
        if (!stream.path.starts_with(prefix)) continue;
        auto& process = *status.add_processes();
        process.set_name(robot->name() + "/" + stream.path.substr(prefix.size()));
        process.set_frames(stream.count);
      }
    }
  }
}

void ReplayRun::Implementation::describePackages(ReplayStatus& status) const {
  for (const auto& source : sources) {
    for (const auto& robot : source->robots) {
      for (const auto& package : robot->plan().packages) {
        auto& row = *status.add_packages();
        row.set_package(robot->name() + "/" + package.name);
        row.set_logged(package.logged);
        row.set_can_recompute(package.canRecompute);
        row.set_why_not(package.whyNot);
        row.set_source(package.source);
        row.set_chosen(package.chosen);
      }
      for (const std::string& task : robot->plan().unavailable) {
        status.add_unavailable_tasks(robot->name() + "/" + task);
      }
      robot->differences().describe(robot->name(), source->log.offset, status);
    }
  }
}

void ReplayRun::Implementation::describeFrame(ReplayStatus& status) const {
  status.set_step_process(stepProcess);
  const Place place = placeOf(framesOf(stepProcess));
  if (place.source == nullptr) return;
  const Instant time = place.source->inLog(now);
  const auto& times = place.source->reader.times(place.stream);
  const auto index = std::upper_bound(times.begin(), times.end(), time) - times.begin();
  status.set_frame_index(static_cast<std::uint64_t>(index));
  if (index > 0) status.set_frame(numberOf(place.source->reader.latest(place.stream, time)));
}

}  // namespace app
