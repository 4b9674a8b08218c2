// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/session/StreamStore.h"

namespace robotcontrol {
class StopwatchTimes;
}

namespace widgets {

/// A frame of a process: a bar of the Gantt chart. It begins at its time on the robot's clock, and is as long
/// as it took in real time.
struct GanttFrame {
  robotlink::Instant time;
  /// 0: unknown.
  std::uint64_t number = 0;
  /// Its duration, and the time within which it had to be done (0: unknown), s.
  double seconds = 0, period = 0;
  /// Its tasks, in order.
  std::shared_ptr<const robotcontrol::StopwatchTimes> times;

  bool overruns() const { return period > 0 && seconds > period; }
};

/// The frames of a process, in order of time.
struct GanttLane {
  std::string process;
  std::vector<GanttFrame> frames;
  /// The number of those that overrun, and the rate of the process at the end of the stretch, Hz.
  std::size_t overruns = 0;
  double rate = 0;
};

/// The process of a stream of stopwatch times; "cognition (logged)" of times that a log has of a process that
/// runs again.
std::string measuredProcess(const std::string& path);

/// Reads the frames of a robot's processes that touch a stretch of time from the session's history, which
/// keeps them; nothing is copied. `periods`: those of the processes that have one, s; the others are to be
/// done before their next frame, by their mean rate over the two seconds before. In the order of the streams'
/// paths.
std::vector<GanttLane> ganttLanes(const robotlink::StreamStore& store, const std::string& robot,
                                  robotlink::Stretch stretch, const std::map<std::string, double>& periods);

}  // namespace widgets
