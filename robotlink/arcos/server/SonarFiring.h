// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotlink::arcos {

/// The schedule of the sonars: each array of eight fires one disc after the other, all arrays simultaneously,
/// so that no disc receives the echo of its neighbor. A pure state machine.
class SonarFiring {
 public:
  static constexpr int kDiscsOfArray = 8;
  static constexpr int kMaxArrays = 4;
  /// Time between two discs of an array unless the client changes it.
  static constexpr Duration kPeriod = std::chrono::milliseconds(40);

  /// `sonars` is the number of discs, at most 32; all arrays are on.
  explicit SonarFiring(int sonars);

  /// SONAR: 1 switches all arrays on, 0 all off; otherwise bit 0 is on or off, and the bits above it the
  /// number of the array, from 1.
  void enable(int argument);
  /// POLLING: the numbers of discs, from 1, in the order in which they are to fire within their arrays; an
  /// empty text switches all off.
  void setSequence(std::string_view discs);
  /// SONARCYCLE, limited to 2 to 120 ms.
  void setPeriod(Duration period);
  /// Returns to the state at power-up.
  void restore();

  /// False for an array that does not exist.
  bool isOn(int array) const;

  /// The discs (from 0) that fire at this instant, one an array. After a late call, only the last round
  /// fires.
  std::vector<int> due(Instant now);
  /// All discs of the arrays that are on.
  std::vector<int> all() const;

 private:
  struct Array {
    bool on = true;
    /// Indices of discs, in the order of firing.
    std::vector<int> sequence;
    // Index of the next one in `sequence`.
    std::size_t next = 0;
  };
  bool fires(int array) const;

  const int sonars_;
  const int arrays_;
  std::array<Array, kMaxArrays> array_;
  Duration period_ = kPeriod;
  /// The time of the next round.
  Instant next_;
};

}  // namespace robotlink::arcos
