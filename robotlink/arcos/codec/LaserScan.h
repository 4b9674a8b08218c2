// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/codec/LaserPacket.h"
#include "robotlink/arcos/codec/StandardInformation.h"
#include "robotlink/base/Clock.h"

namespace robotlink::arcos {

/// A whole scan of a simulator's laser. Reading 0 is where its field of view begins (right),
/// counter-clockwise.
struct LaserScan {
  std::vector<std::uint16_t> rangesMm;
  std::vector<std::uint8_t> reflectances;  ///< as many; all 0 if the laser's packets are plain
  std::uint8_t device = 0;
  Instant takenAt{};  ///< when its first part came
  /// Odometry when its first part came: that packet's own, or of the newest standard information.
  std::int16_t xMm = 0;
  std::int16_t yMm = 0;
  double headingDeg = 0;
  bool operator==(const LaserScan&) const = default;
};

/// Puts the parts of scans together. A scan that lacks a part is dropped and counted; a part that comes twice
/// is heeded once. Holds one scan at most. One thread at a time.
class LaserScanAssembler {
 public:
  /// The scan that this part completes. `information` is the newest one, null if there is none.
  std::optional<LaserScan> take(const LaserPacket& part, const StandardInformation* information, Instant now);
  std::uint64_t incompleteScans() const { return incompleteScans_; }

 private:
  std::optional<LaserScan> scan_;  ///< the one that is being put together
  std::size_t total_ = 0;
  std::uint64_t incompleteScans_ = 0;
};

}  // namespace robotlink::arcos
