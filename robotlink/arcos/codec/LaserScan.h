// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/codec/LaserPacket.h"
#include "robotlink/arcos/codec/StandardInformation.h"
#include "robotlink/base/Clock.h"

namespace robotlink::arcos {

/// A complete scan of a simulator's laser. Reading 0 is at the right end of the field of view; the others
/// follow counterclockwise.
struct LaserScan {
  std::vector<std::uint16_t> rangesMm;
  /// The reflectances, one per reading; all 0 if the packets are plain.
  std::vector<std::uint8_t> reflectances;
  std::uint8_t device = 0;
  /// When its first part arrived.
  Instant takenAt{};
  /// The odometry when the first part arrived: the packet's own, or that of the newest standard information.
  std::int16_t xMm = 0;
  std::int16_t yMm = 0;
  double headingDeg = 0;
  bool operator==(const LaserScan&) const = default;
};

/// Assembles scans from their parts. A scan that lacks a part is dropped and counted; a repeated part is
/// ignored. Stores at most one scan. Not thread-safe.
class LaserScanAssembler {
 public:
  /// Processes a part; returns the scan that it completes. `information` is the newest one, null if there is
  /// none.
  std::optional<LaserScan> take(const LaserPacket& part, const StandardInformation* information, Instant now);
  std::uint64_t incompleteScans() const { return incompleteScans_; }

 private:
  /// The scan being assembled.
  std::optional<LaserScan> scan_;
  /// The number of its readings.
  std::size_t total_ = 0;
  std::uint64_t incompleteScans_ = 0;
};

}  // namespace robotlink::arcos
