// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/base/Clock.h"

namespace app {

/// Counts what goes over a line: how much in the last seconds, the longest gap, and, while somebody wants to
/// see them, the packets themselves. One thread.
class LinkMeter {
 public:
  /// Over which rates and gaps are told.
  static constexpr robotlink::Duration kWindow = std::chrono::seconds(5);

  void setKeeping(bool keeping);
  void packet(bool fromRobot, std::span<const std::uint8_t> bytes, robotlink::Instant now);
  void damage(std::span<const std::uint8_t> bytes, robotlink::Instant now);
  /// A packet that comes once a cycle, whose gaps count.
  void cycle(robotlink::Instant now);
  /// The connection begins anew: no gap over what was before.
  void restart() { lastCycle_.reset(); }

  void fill(robotcontrol::LinkStatus& status, robotlink::Instant now);
  /// Those since the last call; null if there are none.
  std::shared_ptr<robotcontrol::LinkPackets> takePackets(robotlink::Instant now);

 private:
  struct Sample {
    robotlink::Instant time;
    std::size_t bytes = 0;
    bool fromRobot = false;
  };
  struct Gap {
    robotlink::Instant time;
    robotlink::Duration length{};
  };
  void keep(bool fromRobot, bool damaged, std::span<const std::uint8_t> bytes, robotlink::Instant now);
  void forgetOld(robotlink::Instant now);

  bool keeping_ = false;
  std::deque<Sample> samples_;
  std::deque<Gap> gaps_;
  std::optional<robotlink::Instant> lastCycle_;
  std::uint64_t packets_ = 0, dropped_ = 0;
  robotcontrol::LinkPackets kept_;
};

}  // namespace app
