// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotlink::arcos {

/// Which sonar fires when: each array of eight fires one disc after the other, all arrays at the same time,
/// so that no disc hears the echo of its neighbour. A pure state machine.
class SonarFiring {
 public:
  static constexpr int kDiscsOfArray = 8;
  static constexpr int kMaximumArrays = 4;
  /// Between two discs of an array, unless the client sets it.
  static constexpr Duration kPeriod = std::chrono::milliseconds(40);

  explicit SonarFiring(int sonars);

  /// SONAR: 1 all arrays on, 0 all off; otherwise bit 0 says which, and the bits above it which array,
  /// from 1.
  void enable(int argument);
  /// POLLING: the numbers of discs from 1, in the order in which they shall fire, each by its array; empty:
  /// none fires.
  void setSequence(std::string_view discs);
  /// SONARCYCLE, limited to 2 to 120 ms.
  void setPeriod(Duration period);
  /// As the robot begins.
  void restore();

  bool anyOn() const;
  bool isOn(int array) const;  ///< an array that it does not have is never on
  int arrays() const { return arrays_; }

  /// The discs, from 0, that fire at this instant, oldest first. Who asks too late gets the last round only.
  std::vector<int> due(Instant now);
  /// All that are on, whatever their turn.
  std::vector<int> all() const;

 private:
  struct Array {
    bool on = true;
    std::vector<int> sequence;
    std::size_t next = 0;
  };
  bool fires(int array) const;

  const int sonars_;
  const int arrays_;
  std::array<Array, kMaximumArrays> array_;
  Duration period_ = kPeriod;
  Instant next_;
};

}  // namespace robotlink::arcos
