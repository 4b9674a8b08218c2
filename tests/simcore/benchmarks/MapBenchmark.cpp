// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <ctime>
#include <filesystem>

#include "robotlink/base/GroundMap.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/maps/WallBoxes.h"

// The map of a real building, 24 x 52 m with 63 311 points: how long it takes to open, and what sonars and
// lasers of many robots in it cost. The aim for all 16 sonars and a laser of a robot, 10 times a second, is
// less than 0.5 % of a core.
namespace {

using namespace simcore;

const std::filesystem::path kMap = ROBOTCONTROL_SOURCE_DIR "/../shared/data/arcos/columbia.map";

bool isHere(benchmark::State& state) {
  if (std::filesystem::exists(kMap)) return true;
  state.SkipWithError("../shared/data/arcos is not here");
  return false;
}

std::shared_ptr<const Scene> load(int robots) {
  return Scene::load(kMap, {.count = robots}).value();
}

double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void readMap(benchmark::State& state) {
  if (!isHere(state)) return;
  for ([[maybe_unused]] const auto _ : state)
    benchmark::DoNotOptimize(robotlink::GroundMap::load(kMap).value());
}
BENCHMARK(readMap)->Unit(benchmark::kMillisecond);

void gatherWalls(benchmark::State& state) {
  if (!isHere(state)) return;
  const auto map = robotlink::GroundMap::load(kMap).value();
  std::size_t boxes = 0;
  for ([[maybe_unused]] const auto _ : state) boxes = wallBoxes(map).size();
  state.counters["boxes"] = static_cast<double>(boxes);
}
BENCHMARK(gatherWalls)->Unit(benchmark::kMillisecond);

void openScene(benchmark::State& state) {
  if (!isHere(state)) return;
  for ([[maybe_unused]] const auto _ : state)
    benchmark::DoNotOptimize(load(static_cast<int>(state.range(0))));
}
BENCHMARK(openScene)->ArgName("robots")->Arg(0)->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);

void createSimulation(benchmark::State& state) {
  if (!isHere(state)) return;
  const auto scene = load(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] const auto _ : state) benchmark::DoNotOptimize(Simulation::create(scene, {}).value());
}
BENCHMARK(createSimulation)->ArgName("robots")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);

/// One round: every robot measures with all its sensors of a kind once, as ten times a second. The world has
/// moved before, so that the bodies' poses must be taken over, too.
void measure(benchmark::State& state, bool sonars, bool lasers) {
  if (!isHere(state)) return;
  const auto robots = static_cast<int>(state.range(0));
  const auto simulation = std::move(Simulation::create(load(robots), {}).value());
  std::vector<double> ranges(181);
  double seconds = 0;
  for ([[maybe_unused]] const auto _ : state) {
    state.PauseTiming();
    simulation->step();
    state.ResumeTiming();
    const double start = threadSeconds();
    const auto sensors = simulation->rangeSensors();
    for (std::size_t i = 0; i < sensors.size(); ++i) {
      if (sensors[i].kind == RangeSensor::Kind::kSonar ? !sonars : !lasers) continue;
      simulation->measure(i, {ranges.data(), static_cast<std::size_t>(sensors[i].readings)});
    }
    seconds += threadSeconds() - start;
    benchmark::DoNotOptimize(ranges.data());
  }
  const double round = seconds / static_cast<double>(state.iterations()) / robots;
  state.counters["us_per_robot"] = round * 1e6;
  state.counters["percent_of_core_at_10Hz"] = round * 10 * 100;
}
BENCHMARK_CAPTURE(measure, sonars, true, false)
    ->ArgName("robots")
    ->Arg(1)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measure, laser, false, true)
    ->ArgName("robots")
    ->Arg(1)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measure, both, true, true)
    ->ArgName("robots")
    ->Arg(1)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);

}  // namespace
