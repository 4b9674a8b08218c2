// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotcontrol {
class StopwatchTimes;
}

namespace widgets {

/// The time in which a reading of the platform, such as an image, became a command to it. Seconds.
struct Latency {
  /// The names of the packages: "camera/image", "joints/request".
  std::string reading, command;
  /// On the robot's clock: from the reading's timestamp to the beginning of the frame that sent the command.
  double waiting = 0;
  /// In real time: from there to when it was sent; and, where the clock stops while processes compute, what
  /// the processes before took until they sent their results.
  double computing = 0;
  double total() const { return waiting + computing; }
};

/// Follows readings through a robot's processes to the commands that are first based on them, by what
/// StopwatchTimes says of the packages of each frame: a package that one frame received is the one of its
/// name and timestamp that another one sent. All that a frame sends is taken to stem from the newest of each
/// reading that reached it, by whichever way.
///
/// Messages of several processes arrive in any order, so frames are evaluated half a second of the robot's
/// time after they ran; for that time, and a little longer, they are kept. GUI thread.
class LatencyTrace {
 public:
  /// Adds a frame of a process.
  void add(const robotcontrol::StopwatchTimes& times);
  /// Returns what became known since the last call, in order of time; each reading once for each command.
  std::vector<Latency> take();
  /// Forgets everything; this also happens when the clock goes back.
  void clear();

 private:
  struct Origin {
    robotlink::Instant stamp;
    /// s; see Latency::computing.
    double computing = 0;
  };
  struct Package {
    std::string name;
    robotlink::Instant stamp;
    bool ofPlatform = false;
    double seconds = 0;
  };
  struct Frame {
    robotlink::Instant time;
    bool clockStands = false;
    std::vector<Package> received, sent;
    /// Whether `origins` is complete, or being completed.
    bool isResolved = false;
    /// Keyed by reading.
    std::map<std::string, Origin> origins;
  };
  using Frames = std::multimap<robotlink::Instant, Frame>;

  void resolve(Frame& frame);
  /// The frame that sent a package, not later than `until`; null if it is not known.
  Frame* senderOf(const Package& package, robotlink::Instant until);
  void report(const Frame& frame, std::vector<Latency>& to);
  void forget();

  Frames frames_;
  /// The frames that sent a package, by its name and timestamp.
  std::map<std::pair<std::string, robotlink::Instant>, std::vector<Frame*>> senders_;
  /// The newest reading that became a command, by the names of both.
  std::map<std::pair<std::string, std::string>, robotlink::Instant> reported_;
  robotlink::Instant newest_, evaluated_ = robotlink::Instant::min();
};

}  // namespace widgets
