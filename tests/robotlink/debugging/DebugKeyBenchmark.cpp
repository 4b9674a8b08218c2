// SPDX-License-Identifier: GPL-3.0-or-later
// What debug keys that are off cost: a loop that asks one against the same loop that does not, in one run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/DebugContext.h"

using namespace robotlink;

namespace {

const PlotKey kKey{"benchmark/key", "A key that is off"};
constexpr int kQueries = 1 << 20;

// Both loops forget what they know of memory in each round, so that the mode is read again each time, as in
// real code.
int emptyLoop() {
  int drawn = 0;
  for (int i = 0; i < kQueries; ++i) {
    benchmark::DoNotOptimize(drawn);
    benchmark::ClobberMemory();
  }
  return drawn;
}

int askingLoop(DebugContext& debug) {
  int drawn = 0;
  for (int i = 0; i < kQueries; ++i) {
    benchmark::DoNotOptimize(drawn);
    benchmark::ClobberMemory();
    if (debug.on(kKey)) ++drawn;
  }
  return drawn;
}

template <typename Loop>
double nanosecondsPerQuery(const Loop& loop) {
  const auto begin = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(loop());
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
  return took.count() / kQueries;
}

// Alternating, the median of each: what else the machine does hits both alike.
void aKeyThatIsOffAgainstAnEmptyLoop(benchmark::State& state) {
  const ManualClock clock;
  DebugContext debug("benchmark", clock, {});
  std::vector<double> empty, asking;
  for ([[maybe_unused]] auto round : state) {
    empty.push_back(nanosecondsPerQuery(emptyLoop));
    asking.push_back(nanosecondsPerQuery([&] { return askingLoop(debug); }));
  }
  std::sort(empty.begin(), empty.end());
  std::sort(asking.begin(), asking.end());
  const double reference = empty[empty.size() / 2], cost = asking[asking.size() / 2];
  state.counters["ns_empty_loop"] = reference;
  state.counters["ns_key_off"] = cost;
  state.counters["ns_difference"] = cost - reference;
  state.counters["ratio"] = cost / reference;
}
BENCHMARK(aKeyThatIsOffAgainstAnEmptyLoop)->Iterations(101)->Unit(benchmark::kMillisecond);

}  // namespace
