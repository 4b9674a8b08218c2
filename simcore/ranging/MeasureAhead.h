// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "robotlink/base/threads/ThreadPool.h"

namespace simcore {

/// Measures with the sensors of one kind in the threads of a pool: when a sensor is asked for what it
/// measures in a step, it also measures for those that will probably be asked in this step, because so many
/// steps have passed as between the last two times. What a sensor measures must not depend on other
/// measurements. One thread at a time.
template <typename Value>
class MeasureAhead {
 public:
  /// Measures with a sensor. Called in several threads, each with a `lane` of its own below lanes().
  using Measure = std::function<void(std::size_t lane, std::size_t sensor, std::span<Value> values)>;

  /// `sizes` are the numbers of values of the sensors. The pool may be null.
  MeasureAhead(std::shared_ptr<robotlink::ThreadPool> pool, const std::vector<std::size_t>& sizes)
      : pool_(std::move(pool)) {
    for (const std::size_t size : sizes) sensors_.push_back({.size = size});
  }

  std::size_t lanes() const { return pool_ ? static_cast<std::size_t>(pool_->threads()) : 1; }
  /// Call this when the state of a step has changed: what was measured for it is not used.
  void forget() {
    for (Sensor& sensor : sensors_) sensor.madeAt = kNever;
  }
  /// The same, and all that is known of when sensors are asked.
  void restart() {
    for (Sensor& sensor : sensors_) sensor.madeAt = sensor.askedAt = sensor.every = kNever;
  }

  /// Writes what a sensor measures in a step. `mayBe` says of other sensors whether they measure the present
  /// state; otherwise they are measured when they are asked.
  void read(std::size_t sensor, std::uint64_t step, const std::function<bool(std::size_t)>& mayBe,
            const Measure& measure, std::span<Value> values) {
    Sensor& one = sensors_[sensor];
    if (one.askedAt != step) {
      one.every = one.askedAt == kNever || one.askedAt > step ? kNever : step - one.askedAt;
      one.askedAt = step;
    }
    if (one.madeAt != step) make(sensor, step, mayBe, measure);
    std::ranges::copy(one.values, values.begin());
  }

 private:
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};
  struct Sensor {
    std::size_t size = 0;
    /// Empty until they are asked: images are large, and most are never looked at.
    std::vector<Value> values = {};
    /// The steps for which it was made, and in which it was asked last, and those between the last two times.
    std::uint64_t madeAt = kNever, askedAt = kNever, every = kNever;
  };

  void make(std::size_t sensor, std::uint64_t step, const std::function<bool(std::size_t)>& mayBe,
            const Measure& measure) {
    std::vector<std::size_t> wanted{sensor};
    for (std::size_t i = 0; lanes() > 1 && i < sensors_.size(); ++i) {
      const Sensor& one = sensors_[i];
      const bool isExpected = one.every != kNever && one.askedAt + one.every == step && one.madeAt != step;
      if (i != sensor && isExpected && mayBe(i)) wanted.push_back(i);
    }
    for (const std::size_t i : wanted) sensors_[i].values.resize(sensors_[i].size);
    std::atomic<std::size_t> next{0};
    const auto work = [&](std::size_t lane) {
      for (std::size_t i = next++; i < wanted.size(); i = next++)
        measure(lane, wanted[i], sensors_[wanted[i]].values);
    };
    if (wanted.size() > 1) {
      pool_->run(std::min(lanes(), wanted.size()), work);
    } else {
      work(0);
    }
    for (const std::size_t i : wanted) sensors_[i].madeAt = step;
  }

  std::shared_ptr<robotlink::ThreadPool> pool_;
  std::vector<Sensor> sensors_;
};

}  // namespace simcore
