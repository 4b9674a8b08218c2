// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/dds/Node.h"

namespace robotlink::dds {

/// The clock of a robot's programs that do not have its platform: it shows the time of the program that has,
/// whose ClockSource announces it ten times a second. It lags by the shortest delay of an announcement: some
/// ten microseconds on one machine, less than a millisecond in a good network. Before the first announcement
/// it begins at zero. When the other program was started again, it is set back. Any thread.
class FollowedClock final : public Clock {
 public:
  FollowedClock();
  ~FollowedClock() override;

  /// Listens to the announcements for a robot. Fails with the reason of DDS.
  Result<void> follow(const std::shared_ptr<Node>& node, const std::string& robot);
  Instant now() const override;
  /// Whether there was an announcement.
  bool isSet() const { return isSet_.load(); }

  /// An announcement of `source`, a number that changes when it is started again, by a local clock that only
  /// continues.
  void note(std::uint64_t source, Instant announced, Duration local);

 private:
  struct Reader;
  Instant at(Duration local) const;

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;  // protects what follows
  std::uint64_t source_ = 0;
  /// How far the source was ahead of this program's clock, by the last announcements.
  std::array<Duration, 32> ahead_{};
  std::size_t count_ = 0;
  std::atomic<Duration::rep> offset_{0};
  /// The last instant that was shown, so that none is earlier.
  mutable std::atomic<Duration::rep> shown_{0};
  std::atomic<bool> isSet_{false};
  std::unique_ptr<Reader> reader_;
};

/// Announces a clock to all FollowedClocks of a robot, in a thread of its own. The clock must outlive it. It
/// also listens to the LifeSigns of the robot's other programs, so that DDS misses them soon when they end.
class ClockSource {
 public:
  static Result<std::unique_ptr<ClockSource>> open(const std::shared_ptr<Node>& node,
                                                   const std::string& robot, const Clock& clock);
  ~ClockSource();

 private:
  struct Implementation;
  explicit ClockSource(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

/// A sign of life ten times a second, in a thread of its own, of a program that announces no clock.
class LifeSign {
 public:
  static Result<std::unique_ptr<LifeSign>> open(const std::shared_ptr<Node>& node, const std::string& robot);
  ~LifeSign();

 private:
  struct Implementation;
  explicit LifeSign(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink::dds
