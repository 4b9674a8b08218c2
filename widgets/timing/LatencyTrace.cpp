// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/LatencyTrace.h"

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/packages/Conversions.h"

namespace widgets {
namespace {

using robotlink::Instant;

constexpr robotlink::Duration kSettle = std::chrono::milliseconds(500);
constexpr robotlink::Duration kKeep = std::chrono::seconds(5);
constexpr std::size_t kMaxFrames = 20'000;

}  // namespace

void LatencyTrace::clear() {
  *this = {};
}

void LatencyTrace::add(const robotcontrol::StopwatchTimes& times) {
  const Instant time = robotlink::instant(times.timestamp());
  if (!frames_.empty() && time < newest_ - kKeep) clear();
  newest_ = frames_.empty() ? time : std::max(newest_, time);
  Frame& frame = frames_.emplace(time, Frame())->second;
  frame.time = time;
  frame.clockStands = times.clock_stands();
  const auto copied = [](const robotcontrol::StopwatchTimes::Package& package) {
    return Package{package.name(), robotlink::instant(package.timestamp()), package.of_platform(),
                   package.seconds()};
  };
  for (const auto& package : times.received()) frame.received.push_back(copied(package));
  for (const auto& package : times.sent()) {
    frame.sent.push_back(copied(package));
    senders_[{package.name(), frame.sent.back().stamp}].push_back(&frame);
  }
  forget();
}

void LatencyTrace::forget() {
  while (!frames_.empty() && (frames_.begin()->first < newest_ - kKeep || frames_.size() > kMaxFrames)) {
    Frame& oldest = frames_.begin()->second;
    for (const Package& package : oldest.sent) {
      const auto found = senders_.find({package.name, package.stamp});
      if (found == senders_.end()) continue;
      std::erase(found->second, &oldest);
      if (found->second.empty()) senders_.erase(found);
    }
    frames_.erase(frames_.begin());
  }
}

LatencyTrace::Frame* LatencyTrace::senderOf(const Package& package, Instant until) {
  const auto found = senders_.find({package.name, package.stamp});
  if (found == senders_.end()) return nullptr;
  Frame* latest = nullptr;
  for (Frame* sender : found->second) {
    if (sender->time <= until && (latest == nullptr || sender->time >= latest->time)) latest = sender;
  }
  return latest;
}

void LatencyTrace::resolve(Frame& frame) {
  // Set first: processes that exchange packages both ways have no end otherwise.
  if (std::exchange(frame.isResolved, true)) return;
  const auto offer = [&frame](const std::string& reading, const Origin& origin) {
    const auto [known, isNew] = frame.origins.try_emplace(reading, origin);
    if (isNew || origin.stamp < known->second.stamp) return;
    const bool isSame = origin.stamp == known->second.stamp;
    known->second = {origin.stamp,
                     isSame ? std::max(origin.computing, known->second.computing) : origin.computing};
  };
  for (const Package& package : frame.received) {
    if (package.ofPlatform) {
      offer(package.name, {package.stamp, 0});
      continue;
    }
    Frame* sender = senderOf(package, frame.time);
    if (sender == nullptr || sender == &frame) continue;
    resolve(*sender);
    const auto sent = std::ranges::find_if(sender->sent, [&](const Package& candidate) {
      return candidate.name == package.name && candidate.stamp == package.stamp;
    });
    // While the clock continues, what a process takes is in the time of the next one's frame.
    const double took = sender->clockStands ? sent->seconds : 0;
    for (const auto& [reading, origin] : sender->origins)
      offer(reading, {origin.stamp, origin.computing + took});
  }
}

void LatencyTrace::report(const Frame& frame, std::vector<Latency>& to) {
  for (const Package& command : frame.sent) {
    if (!command.ofPlatform) continue;
    for (const auto& [reading, origin] : frame.origins) {
      const auto [newest, isFirst] = reported_.try_emplace({reading, command.name}, origin.stamp);
      if (!isFirst && origin.stamp <= newest->second) continue;
      newest->second = origin.stamp;
      const double waiting = robotlink::seconds(frame.time - origin.stamp);
      // The clocks of the reading and of the program differ.
      if (waiting < 0) continue;
      to.push_back({reading, command.name, waiting, origin.computing + command.seconds});
    }
  }
}

std::vector<Latency> LatencyTrace::take() {
  std::vector<Latency> known;
  const Instant until = newest_ - kSettle;
  for (auto at = frames_.upper_bound(evaluated_); at != frames_.end() && at->first <= until; ++at) {
    resolve(at->second);
    report(at->second, known);
    evaluated_ = at->first;
  }
  return known;
}

}  // namespace widgets
