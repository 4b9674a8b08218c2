// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/Clock.h"

namespace app {

/// Measures the traffic on the line to a Pioneer: rates and the longest gap over the last seconds, and, while
/// a view wants them, the packets themselves. One thread.
class LinkMeter {
 public:
  /// The time span of rates and gaps.
  static constexpr robotlink::Duration kWindow = std::chrono::seconds(5);

  /// Whether packets are kept for takePackets(). Switching it off drops those that are kept.
  void setKeeping(bool keeping);
  /// Counts a packet that passed; `frame` has its bytes with header and checksum, or is empty if it was
  /// handed over as a value.
  void packet(bool fromRobot, const robotlink::arcos::Packet& packet, std::span<const std::uint8_t> frame,
              robotlink::Instant now);
  /// Keeps bytes that were no packet, or one with a wrong checksum. They count in no rate.
  void damage(std::span<const std::uint8_t> bytes, robotlink::Instant now);
  /// Call this for the packet that the robot sends once a cycle; gaps are measured between these.
  void cycle(robotlink::Instant now);
  /// Call this when a connection ends, so that the time without one is no gap, and what was dropped is not
  /// counted for the next one.
  void restart() {
    lastCycle_.reset();
    dropped_ = 0;
  }

  /// Fills in the packet count, rates per second, and the longest gap in seconds.
  void fill(robotcontrol::LinkStatus& status, robotlink::Instant now);
  /// Returns the packets since the last call; null if there are none. At most 2000 are kept in between; the
  /// number of those dropped since the connection began is included.
  std::shared_ptr<robotcontrol::LinkPackets> takePackets(robotlink::Instant now);

 private:
  /// The size of a packet.
  struct Sample {
    robotlink::Instant time;
    std::size_t bytes = 0;
    bool fromRobot = false;
  };
  /// The time between two cycles, of which the second ended at `time`.
  struct Gap {
    robotlink::Instant time;
    robotlink::Duration length{};
  };
  /// Adds a packet to kept_ if packets are wanted and there is room.
  void keep(bool fromRobot, bool damaged, std::span<const std::uint8_t> bytes, robotlink::Instant now);
  /// Removes what is older than kWindow.
  void forgetOld(robotlink::Instant now);

  bool keeping_ = false;
  /// The packets of the last kWindow, in order of time.
  std::deque<Sample> samples_;
  std::deque<Gap> gaps_;
  std::optional<robotlink::Instant> lastCycle_;
  /// From the robot in all, and packets that were not kept.
  std::uint64_t packets_ = 0, dropped_ = 0;
  robotcontrol::LinkPackets kept_;
};

}  // namespace app
