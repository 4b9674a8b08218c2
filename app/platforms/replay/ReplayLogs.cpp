// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayLogs.h"

#include <algorithm>

#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"

namespace app {

namespace streams = robotlink::streams;

using robotcontrol::FrameInfo;
using robotcontrol::ReplayStatus;
using robotlink::Instant;

namespace {

std::int64_t nanoseconds(Instant time) {
  return time.time_since_epoch().count();
}

std::uint64_t frameNumberOf(const std::optional<robotlink::StreamMessage>& message) {
  const auto* info = message ? dynamic_cast<const FrameInfo*>(message->value.get()) : nullptr;
  return info != nullptr ? info->number() : 0;
}

/// Whether a process waits for images.
bool blocksOnImages(const robotlink::Layout::Process& process) {
  return std::ranges::any_of(process.blocking,
                             [](const auto& input) { return input.package == robotlink::kCameraImage.name; });
}

}  // namespace

ReplayLogs::Source& ReplayLogs::add(const ReplayLog& log, std::shared_ptr<logplayer::LogFile> file) {
  const auto hasScene = [](const auto& source) {
    const auto& all = source->reader.file().streams();
    return std::ranges::any_of(all, [](const auto& stream) { return stream.path == streams::kScene; });
  };
  const bool publishesWorld = std::ranges::none_of(sources_, hasScene);
  return *sources_.emplace_back(new Source{log, ReplaySource(std::move(file)), publishesWorld});
}

// ---- Time

Instant ReplayLogs::begin() const {
  Instant earliest = Instant::max();
  for (const auto& source : sources_)
    earliest = std::min(earliest, source->onLine(source->reader.file().begin()));
  return earliest;
}

Instant ReplayLogs::end() const {
  Instant latest = Instant::min();
  for (const auto& source : sources_) latest = std::max(latest, source->onLine(source->reader.file().end()));
  return latest;
}

std::optional<Instant> ReplayLogs::nextTime() const {
  std::optional<Instant> next;
  for (const auto& source : sources_) {
    const auto own = source->reader.nextTime();
    if (own && (!next || source->onLine(*own) < *next)) next = source->onLine(*own);
  }
  return next;
}

// ---- Robots, streams, frames

std::vector<ReplayRobot*> ReplayLogs::robots() const {
  std::vector<ReplayRobot*> all;
  for (const auto& source : sources_) {
    for (const auto& robot : source->robots) all.push_back(robot.get());
  }
  return all;
}

ReplayRobot* ReplayLogs::find(const std::string& name) const {
  for (ReplayRobot* robot : robots()) {
    if (robot->name() == name) return robot;
  }
  return nullptr;
}

std::string ReplayLogs::freeName(const std::string& robot) const {
  std::string name = robot;
  for (int number = 2; find(name) != nullptr; ++number) name = robot + "-" + std::to_string(number);
  return name;
}

ReplayLogs::Place ReplayLogs::placeOf(const std::string& stream) const {
  for (const auto& source : sources_) {
    for (const auto& [logName, robot] : source->byLogName) {
      if (!stream.starts_with(robot->name() + "/")) continue;
      std::string path = stream.substr(robot->name().size() + 1);
      if (path.starts_with(streams::kLogged)) path.erase(0, std::string_view(streams::kLogged).size());
      return {source.get(), logName + "/" + path};
    }
  }
  // A stream that belongs to no robot comes from the first log that has it and publishes such streams.
  for (const auto& source : sources_) {
    if (source->publishesWorld && !source->reader.times(stream).empty()) return {source.get(), stream};
  }
  return {};
}

std::string ReplayLogs::framesOf(const std::string& process) {
  const auto slash = process.find('/');
  if (slash == std::string::npos) return {};
  return process.substr(0, slash + 1) + streams::kFrames + process.substr(slash + 1);
}

std::optional<Instant> ReplayLogs::firstTime(const std::string& stream) const {
  const Place place = placeOf(stream);
  if (place.source == nullptr) return std::nullopt;
  const auto& times = place.source->reader.times(place.stream);
  return times.empty() ? std::nullopt : std::optional(place.source->onLine(times.front()));
}

std::optional<Instant> ReplayLogs::countedTime(const std::string& stream, int count, Instant now) const {
  const Place place = placeOf(stream);
  if (place.source == nullptr) return std::nullopt;
  const auto& times = place.source->reader.times(place.stream);
  if (times.empty()) return std::nullopt;
  // Several messages at one instant count as one step.
  auto at = std::ranges::upper_bound(times, place.source->inLog(now));
  for (int step = 1; step < count && at != times.end(); ++step) at = std::upper_bound(at, times.end(), *at);
  // Past the last message, or when not stepping forward, begin at the message before.
  if (at == times.end() || (count <= 0 && at != times.begin())) --at;
  for (int step = 0; step > count && at != times.begin(); --step) {
    at = std::lower_bound(times.begin(), at, *at);
    if (at != times.begin()) --at;
  }
  return place.source->onLine(*at);
}

// The numbers of frames grow with time, so a binary search has to read only few of them.
std::optional<Instant> ReplayLogs::timeOfFrame(const std::string& process, std::uint64_t frame) const {
  const Place place = placeOf(framesOf(process));
  if (place.source == nullptr) return std::nullopt;
  const auto& times = place.source->reader.times(place.stream);
  const auto found = std::partition_point(times.begin(), times.end(), [&](Instant time) {
    return frameNumberOf(place.source->reader.latest(place.stream, time)) < frame;
  });
  if (found == times.end() || frameNumberOf(place.source->reader.latest(place.stream, *found)) != frame)
    return std::nullopt;
  return place.source->onLine(*found);
}

std::string ReplayLogs::stepProcess() const {
  // The best candidate is the last one.
  std::vector<std::string> best;
  for (const auto& source : sources_) {
    for (const auto& [logName, robot] : source->byLogName) {
      const std::string prefix = logName + "/" + streams::kFrames;
      // In the same order, for this robot.
      std::vector<std::string> names;
      for (const auto& stream : source->reader.file().streams()) {
        if (!stream.path.starts_with(prefix)) continue;
        const std::string process = stream.path.substr(prefix.size());
        const auto& all = robot->setup().layout.processes;
        const auto known = std::ranges::find_if(all, [&](const auto& p) { return p.name == process; });
        const bool takesImages = known != all.end() && blocksOnImages(*known);
        names.insert(takesImages ? names.end() : names.begin(), robot->name() + "/" + process);
      }
      best.insert(best.begin(), names.begin(), names.end());
    }
  }
  return best.empty() ? std::string() : best.back();
}

// ---- Description

void ReplayLogs::describe(ReplayStatus& status) const {
  status.set_begin(nanoseconds(begin()));
  status.set_end(nanoseconds(end()));
  describeLogs(status);
  describePackages(status);
}

void ReplayLogs::describeLogs(ReplayStatus& status) const {
  for (const auto& source : sources_) {
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

void ReplayLogs::describePackages(ReplayStatus& status) const {
  for (const auto& source : sources_) {
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

void ReplayLogs::describeFrame(const std::string& process, Instant now, ReplayStatus& status) const {
  const Place place = placeOf(framesOf(process));
  if (place.source == nullptr) return;
  const Instant time = place.source->inLog(now);
  const auto& times = place.source->reader.times(place.stream);
  const auto index = std::ranges::upper_bound(times, time) - times.begin();
  status.set_frame_index(static_cast<std::uint64_t>(index));
  if (index > 0) status.set_frame(frameNumberOf(place.source->reader.latest(place.stream, time)));
}

}  // namespace app
