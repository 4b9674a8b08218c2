// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace app {

/// Decides which of a sender's texts are shown: kBurst at once, afterwards kPerSecond; the others are
/// counted, and their number is to be shown once a second. A plain value: the time is passed in.
class TextLimit {
 public:
  using RealTime = std::chrono::steady_clock::time_point;
  static constexpr int kBurst = 20;
  static constexpr int kPerSecond = 5;

  /// Whether one more text may be shown.
  bool admit(RealTime now);
  /// How many were not shown since the last answer other than 0, at most once a second.
  std::uint64_t takeSuppressed(RealTime now);
  /// Of all time.
  std::uint64_t suppressed() const { return suppressed_; }

 private:
  double tokens_ = kBurst;
  RealTime refilled_;
  RealTime counted_;  ///< when the first text was suppressed of those that are not yet told
  std::uint64_t suppressed_ = 0, reported_ = 0;
};

}  // namespace app
