// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/GanttFrames.h"

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/TypedStreams.h"
#include "widgets/timing/FrameRate.h"

namespace widgets {
namespace {

/// Frames that began this long before a stretch, and are still running in it, are found.
constexpr robotlink::Duration kBeforeStretch = std::chrono::seconds(2);

double wholeSecondsOf(const robotcontrol::StopwatchTimes& times) {
  double sum = 0;
  for (const auto& entry : times.entries()) {
    if (entry.task().empty()) return entry.seconds();
    sum += entry.seconds();
  }
  return sum;
}

}  // namespace

std::string measuredProcess(const std::string& path) {
  const bool isLogged = path.find(std::string("/") + robotlink::streams::kLogged) != std::string::npos;
  return isLogged ? lastPart(path) + " (logged)" : lastPart(path);
}

std::vector<GanttLane> ganttLanes(const robotlink::StreamStore& store, const std::string& robot,
                                  robotlink::Stretch stretch, const std::map<std::string, double>& periods) {
  std::vector<GanttLane> lanes;
  for (const auto* stream : streamsOfType(store, robot, "robotcontrol.StopwatchTimes")) {
    GanttLane& lane = lanes.emplace_back();
    lane.process = measuredProcess(stream->path);
    const auto known = periods.find(lane.process);
    const double period = known == periods.end() ? 0 : known->second;
    FrameRate rate;
    const auto& messages = stream->messages;
    auto at = std::ranges::lower_bound(messages, stretch.from - kBeforeStretch, {},
                                       &robotlink::StreamMessage::time);
    for (; at != messages.end() && at->time <= stretch.to; ++at) {
      auto times = std::dynamic_pointer_cast<const robotcontrol::StopwatchTimes>(at->value);
      if (times == nullptr) continue;
      rate.add(at->time, at->frame);
      const double seconds = wholeSecondsOf(*times);
      if (at->time + robotlink::fromSeconds(seconds) < stretch.from) continue;
      lane.frames.push_back({at->time, at->frame, seconds, rate.period(period), std::move(times)});
      if (lane.frames.back().overruns()) ++lane.overruns;
    }
    lane.rate = rate.hertz();
  }
  return lanes;
}

}  // namespace widgets
