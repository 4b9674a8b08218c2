// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "app/platforms/simulated/SimulatedRun.h"

// Runs of the shipped scene, without a window or a thread.
namespace app::test {

inline RunOptions simulationOptions(std::uint64_t seed = 1) {
  RunOptions options = defaultSimulation();
  options.world.seed = seed;
  return options;
}

/// A run, or null after a failure of the test.
inline std::unique_ptr<SimulatedRun> makeRun(const RunOptions& options,
                                             SimulatedRun::Listeners listeners = {}) {
  auto run = SimulatedRun::create(options, std::move(listeners));
  EXPECT_TRUE(run.has_value()) << (run ? "" : robotlink::describe(run.error()));
  return run ? std::move(*run) : nullptr;
}

/// Steps a run for some seconds of its own time.
inline void play(SimulatedRun& run, double seconds) {
  const robotlink::Instant end = run.world().clock().now() + robotlink::fromSeconds(seconds);
  while (run.world().clock().now() < end) run.step();
}

}  // namespace app::test
