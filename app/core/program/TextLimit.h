// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace app {

/// Limits the rate at which the texts of one sender are shown: kBurst at once, then kPerSecond. The others
/// are counted, and the count is to be shown once a second. A token bucket; a plain value, to which the time
/// is passed.
class TextLimit {
 public:
  using RealTime = std::chrono::steady_clock::time_point;
  static constexpr int kBurst = 20;
  static constexpr int kPerSecond = 5;

  /// Whether one more text may be shown; counts it otherwise.
  bool admit(RealTime now);
  /// The number of texts suppressed since the last result other than 0; 0 if that is less than a second ago.
  std::uint64_t takeSuppressed(RealTime now);
  /// The total number of suppressed texts.
  std::uint64_t suppressed() const { return suppressed_; }

 private:
  /// The number of texts that could be shown at refilled_.
  double tokens_ = kBurst;
  RealTime refilled_;
  /// The time of the first of the unreported suppressed texts.
  RealTime counted_;
  /// Suppressed in all, and of these returned by takeSuppressed().
  std::uint64_t suppressed_ = 0, reported_ = 0;
};

}  // namespace app
