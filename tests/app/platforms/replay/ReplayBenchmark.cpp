// SPDX-License-Identifier: GPL-3.0-or-later
// What a replay of the real log costs: opening it, a frame forwards, a frame backwards.
// ROBOTCONTROL_REPLAY_LOG names another log.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "app/platforms/replay/ReplayRun.h"

namespace {

std::unique_ptr<app::ReplayRun> openReplay(benchmark::State& state) {
  app::ReplayOptions options;
  const char* other = std::getenv("ROBOTCONTROL_REPLAY_LOG");
  options.logs = {{other != nullptr ? other : ROBOTCONTROL_SOURCE_DIR "/../shared/data/logs/bhuman2009.log"}};
  auto run = app::ReplayRun::create(std::move(options), {});
  if (!run) state.SkipWithError(robotlink::describe(run.error()).c_str());
  return run ? std::move(*run) : nullptr;
}

void open(benchmark::State& state) {
  for (auto _ : state) {
    const auto run = openReplay(state);
    if (!run) return;
    benchmark::DoNotOptimize(run->jump(*run->frameTime(run->stepProcess(), 0)));
  }
}

void stepForwards(benchmark::State& state) {
  const auto run = openReplay(state);
  if (!run) return;
  for (auto _ : state) {
    const auto next = *run->frameTime(run->stepProcess(), 1);
    if (next <= run->now()) {
      state.PauseTiming();
      (void)run->jump(run->begin());
      state.ResumeTiming();
      continue;
    }
    while (run->now() < next) run->step();
  }
}

void stepBackwards(benchmark::State& state) {
  const auto run = openReplay(state);
  if (!run) return;
  (void)run->jump(run->end());
  for (auto _ : state) {
    const auto before = *run->frameTime(run->stepProcess(), -1);
    benchmark::DoNotOptimize(run->jump(before < run->now() ? before : run->end()));
  }
}

}  // namespace

BENCHMARK(open)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(stepForwards)->Unit(benchmark::kMillisecond);
BENCHMARK(stepBackwards)->Unit(benchmark::kMillisecond);
