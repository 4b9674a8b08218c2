// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "robotlink/base/threads/ThreadPool.h"
#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "tests/simcore/BareOde.h"
#include "tests/simcore/SceneFixture.h"

// A step of the field with one robot through simcore, against the same world stepped by bare ODE calls in
// turns with it; the aim is a ratio under 1.15. Both servo the same stance. Times are those of the thread's
// processor time, so others on the machine do not count.
namespace {

using namespace simcore;

double threadMicroseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e6 + static_cast<double>(time.tv_nsec) * 1e-3;
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// A world with the field, the ball and so many robots.
std::string worldWith(int robots, const std::string& inWorld = "") {
  std::string contents =
      inWorld +
      "<include><uri>model://field2002</uri></include><include><uri>model://ball</uri><pose>0 0 0.0421 0 0 "
      "0</pose></include>";
  for (int i = 0; i < robots; ++i) {
    contents += "<include><uri>model://ers210</uri><name>red" + std::to_string(i + 1) + "</name><pose>" +
                std::to_string(-1.8 + 0.45 * i) + " 0.7 0.1138 0 0 0</pose></include>";
  }
  return worldAround(contents);
}

std::shared_ptr<const Scene> load(int robots, const std::string& inWorld = "") {
  const SceneFolder folder;
  folder.copyShippedModels();
  return Scene::load(folder.write("world.sdf", worldWith(robots, inWorld))).value();
}

void stepAgainstBareOde(benchmark::State& state) {
  constexpr int kBatch = 50;
  // What sleeps takes no time; bare ODE does not let it.
  const auto scene = load(1, "<robotcontrol:sleeping>false</robotcontrol:sleeping>");
  test::BareOde bare(*scene);
  const auto simulation = std::move(Simulation::create(scene, {}).value());
  std::vector<double> ours, theirs;
  const auto measure = [](std::vector<double>& times, const std::function<void()>& run) {
    const double start = threadMicroseconds();
    for (int i = 0; i < kBatch; ++i) run();
    times.push_back((threadMicroseconds() - start) / kBatch);
  };
  const bool sensors = state.range(0) != 0;
  for ([[maybe_unused]] const auto _ : state) {
    measure(ours, [&] {
      simulation->step();
      // A robot's frame is two steps.
      if (sensors && simulation->steps() % 2 == 0) benchmark::DoNotOptimize(simulation->sensors().data());
    });
    measure(theirs, [&] { bare.step(); });
  }
  state.counters["ours_us"] = median(ours);
  state.counters["ode_us"] = median(theirs);
  state.counters["ratio"] = median(ours) / median(theirs);
}
BENCHMARK(stepAgainstBareOde)->ArgName("sensors")->Arg(0)->Arg(1)->MinTime(2);

void loadScene(benchmark::State& state) {
  const SceneFolder folder;
  folder.copyShippedModels();
  const auto file = folder.write("world.sdf", worldWith(static_cast<int>(state.range(0))));
  for ([[maybe_unused]] const auto _ : state) benchmark::DoNotOptimize(Scene::load(file).value());
}
BENCHMARK(loadScene)->ArgName("robots")->Arg(1)->Arg(8)->Unit(benchmark::kMillisecond);

void reset(benchmark::State& state) {
  const auto simulation = std::move(Simulation::create(shippedScene(), {}).value());
  for ([[maybe_unused]] const auto _ : state) simulation->reset(1);
}
BENCHMARK(reset)->Unit(benchmark::kMicrosecond);

/// Has all servos swing about where they are at the start, so that no robot sleeps.
void swing(Simulation& simulation, const std::vector<double>& stance) {
  const double time = robotlink::seconds(simulation.time());
  for (std::size_t i = 0; i < stance.size(); ++i)
    simulation.requestAngle(i, stance[i] + 0.1 * std::sin(6 * time + static_cast<double>(i)));
}

/// The wall-clock time of a step by one and by several threads, in turns; robots that stand still sleep.
void stepRobots(benchmark::State& state) {
  constexpr int kBatch = 25;
  const auto scene = load(static_cast<int>(state.range(0)));
  const auto make = [&](int threads) {
    return std::move(
        Simulation::create(scene, {.pool = std::make_shared<robotlink::ThreadPool>(threads)}).value());
  };
  const auto alone = make(1), together = make(static_cast<int>(state.range(1)));
  std::vector<double> one, several, stance;
  for (const ModelInstance& instance : scene->contents().world.models) {
    for (const JointDescription& joint : instance.type->joints)
      if (joint.servo) stance.push_back(joint.initialAngle);
  }
  if (state.range(2) == 0) stance.clear();
  const auto measure = [&](Simulation& simulation, std::vector<double>& times) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kBatch; ++i) {
      swing(simulation, stance);
      simulation.step();
    }
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    times.push_back(took.count() / kBatch);
  };
  for ([[maybe_unused]] const auto _ : state) {
    measure(*alone, one);
    measure(*together, several);
  }
  state.counters["one_us"] = median(one);
  state.counters["several_us"] = median(several);
  state.counters["times_faster"] = median(one) / median(several);
  state.counters["same_bytes"] = alone->digest() == together->digest() ? 1 : 0;
}
BENCHMARK(stepRobots)
    ->ArgNames({"robots", "threads", "moving"})
    ->ArgsProduct({{1, 4, 8}, {2}, {0, 1}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
