// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <chrono>
#include <map>

#include "app/core/program/LeftOverPrograms.h"
#include "app/core/program/ShippedFiles.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/threads/ThreadPool.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "tests/app/Requests.h"
#include "tests/app/SimulatedRuns.h"
#include "tests/simcore/BareOde.h"

// Four-legged robots with their whole programs, cameras at 25 Hz with shadows and noise: what one and what
// several threads make of them, in turns in one run, and where the time goes. Columns:
//   times_real, times_real_1  how many times real time, with several threads and with one
//   faster                    the ratio of the two
//   limit                     the ratio that is possible by Amdahl's law if physics, cameras and programs
//                             (but not the finding of contacts, nor passing messages) share the threads
//   of_limit                  faster / limit, percent
//   physics, cameras, programs, rest     shares of one thread's time, percent
//   debugging                 what images and drawings of all robots cost in addition, percent of that time
//   step_us, ode_us           a physical step of 4 ms with one thread, and by bare calls of ODE in the same
//   run
// Times are real time, so that others on the machine count; ratios of one run are less affected.
namespace {

using namespace app;
using namespace app::test;

constexpr double kSlice = 0.2, kWarmUp = 0.6;
constexpr int kSlices = 6;
/// The share of a physical step that one thread has to do: finding contacts and reading sensors.
constexpr double kSerialPhysics = 0.08;

RunOptions gameOf(int robots, int threads) {
  RunOptions options = simulationOptions();
  options.world.threads = threads;
  // As robotctl and the workbench do.
  options.patience = kModulePatience;
  // The shipped scene has one.
  if (robots > 1) options.robots = simcore::RobotsToAdd{.model = "ers210", .count = robots - 1};
  return options;
}

double secondsOf(const std::function<void()>& run) {
  const auto begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A run with the real time that its slices took.
struct Measured {
  std::unique_ptr<SimulatedRun> run;
  double seconds = 0;
  SimulatedWorld::Costs before = {};
  robotlink::Duration programsBefore{};

  explicit Measured(std::unique_ptr<SimulatedRun> of) : run(std::move(of)) {
    play(*run, kWarmUp);
    before = run->world().costs();
    programsBefore = run->programTime();
  }
  void slice() {
    seconds += secondsOf([this] { play(*run, kSlice); });
  }
  double physics() const { return robotlink::seconds(run->world().costs().physics - before.physics); }
  double cameras() const { return robotlink::seconds(run->world().costs().rendering - before.rendering); }
  double programs() const { return robotlink::seconds(run->programTime() - programsBefore); }
  double steps() const { return static_cast<double>(run->world().costs().steps - before.steps); }
};

/// Asks for what a window shows with the scene, the field and an image of each robot.
void look(SimulatedRun& run) {
  for (const std::string& robot : run.robots()) {
    for (const char* key : {"package/camera/image", "package/percepts/ball", "package/models/pose"})
      (void)run.request(keyRequest(robot, key));
  }
}

void report(benchmark::State& state, const Measured& one, const Measured& several, const Measured& looked,
            double odeSeconds, double odeSteps) {
  const double simulated = kSlice * kSlices, threads = several.run->world().options().threads;
  const double whole = one.seconds;
  const double shared = (one.physics() * (1 - kSerialPhysics) + one.cameras() + one.programs()) / whole;
  const double limit = 1 / (1 - shared + shared / threads), faster = one.seconds / several.seconds;
  const auto percent = [&](double seconds) { return 100 * seconds / whole; };
  state.counters["times_real"] = simulated / several.seconds;
  state.counters["times_real_1"] = simulated / one.seconds;
  state.counters["faster"] = faster;
  state.counters["limit"] = limit;
  state.counters["of_limit"] = 100 * faster / limit;
  state.counters["physics"] = percent(one.physics());
  state.counters["cameras"] = percent(one.cameras());
  state.counters["programs"] = percent(one.programs());
  state.counters["rest"] = percent(whole - one.physics() - one.cameras() - one.programs());
  state.counters["debugging"] = percent(looked.seconds - whole);
  state.counters["step_us"] = 1e6 * one.physics() / one.steps();
  state.counters["ode_us"] = 1e6 * odeSeconds / odeSteps;
  state.counters["same_bytes"] = one.run->world().digest() == several.run->world().digest() ? 1 : 0;
}

void game(benchmark::State& state) {
  const int robots = static_cast<int>(state.range(0));
  const int threads = std::max(2, robotlink::ThreadPool::cores());
  Measured one(makeRun(gameOf(robots, 1))), several(makeRun(gameOf(robots, threads))),
      looked(makeRun(gameOf(robots, 1), {.queue = [](const std::string&, auto) {}, .trouble = {}}));
  look(*looked.run);
  simcore::test::BareOde ode(one.run->world().simulation().scene());
  double odeSeconds = 0, odeSteps = 0;
  for ([[maybe_unused]] const auto _ : state) {
    for (int i = 0; i < kSlices; ++i) {
      for (Measured* each : {&one, &several, &looked}) each->slice();
      odeSeconds += secondsOf([&] {
        for (int step = 0; step < 50; ++step) ode.step();
      });
      odeSteps += 50;
    }
  }
  report(state, one, several, looked, odeSeconds, odeSteps);
}
// For more than 28 there is no room on the field.
BENCHMARK(game)
    ->ArgName("robots")
    ->ArgsProduct({{1, 2, 4, 8, 16, 28}})
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// What perception and models of a robot take of an image of 176 x 144 in a game of eight, with one thread:
/// the whole, and each task, us a frame. What behavior takes is not in the whole.
void frame(benchmark::State& state) {
  std::map<std::string, double> seconds;
  std::map<std::string, double> frames;
  SimulatedRun::Listeners listeners;
  listeners.queue = [&](const std::string&, const std::shared_ptr<const robotlink::SharedDebugQueue>& queue) {
    for (const auto& message : queue->messages) {
      const auto* times = message.as<robotcontrol::StopwatchTimes>();
      if (times == nullptr || message.path != "stopwatches/cognition") continue;
      for (const auto& entry : times->entries()) {
        seconds[entry.task()] += entry.seconds();
        ++frames[entry.task()];
      }
    }
  };
  RunOptions options = gameOf(1, 1);
  options.scene = sceneNamed("game2002");
  const auto run = makeRun(options, listeners);
  for (const std::string& robot : run->robots()) (void)run->request(keyRequest(robot, "timing/tasks"));
  constexpr double kKickOff = 5;
  play(*run, kKickOff);
  seconds.clear();
  frames.clear();
  for ([[maybe_unused]] const auto _ : state) play(*run, 10);
  double whole = 0;
  for (const auto& [task, time] : seconds) {
    if (task.empty()) continue;
    const double mean = 1e6 * time / frames[task];
    state.counters[task] = mean;
    if (task != "behavior") whole += mean;
  }
  state.counters["whole_us"] = whole;
}
BENCHMARK(frame)->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Has all servos swing, so that no robot sleeps.
void swing(simcore::Simulation& simulation) {
  const double time = robotlink::seconds(simulation.time());
  for (std::size_t i = 0; i < simulation.servos().size(); ++i) {
    const simcore::Servo& servo = simulation.servos()[i];
    const double middle = (servo.minimum + servo.maximum) / 2;
    simulation.requestAngle(i, middle + 0.1 * std::sin(6 * time + static_cast<double>(i)));
  }
}

/// Eight robots with all sensors and images, without programs: how many times real time. Images that are late
/// by some milliseconds are made while the physics goes on.
void sensors(benchmark::State& state) {
  const int threads = static_cast<int>(state.range(0));
  const RunOptions options = gameOf(8, threads);
  simcore::RobotsToAdd added = *options.robots;
  const auto scene = simcore::Scene::load(options.scene, added);
  if (!scene) return state.SkipWithError("the shipped scene could not be loaded");
  SimulatedWorld::Options world = options.world;
  const auto made = SimulatedWorld::create(*scene, world);
  if (!made) return state.SkipWithError(made.error().text.c_str());
  for (const auto& camera : (*made)->simulation().cameras()) {
    simcore::SensorErrors errors;
    errors.delay = static_cast<double>(state.range(2)) / 1000;
    if (errors.delay > 0 && !(*made)->setSensorErrors(camera.info.path, errors))
      return state.SkipWithError("a camera has no delay");
  }
  double simulated = 0;
  const auto begin = std::chrono::steady_clock::now();
  for ([[maybe_unused]] const auto _ : state) {
    if (state.range(1) != 0) swing((*made)->simulation());
    (*made)->advance();
    benchmark::DoNotOptimize((*made)->simulation().sensors().data());
    for (std::size_t camera = 0; camera < (*made)->simulation().cameras().size(); ++camera) {
      if ((*made)->imageDue(camera)) benchmark::DoNotOptimize((*made)->render(camera).data.data());
    }
    simulated += robotlink::seconds(SimulatedWorld::kStep);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  state.counters["times_real"] = simulated / took.count();
  state.counters["begun_ahead"] = static_cast<double>((*made)->imagesBegunAhead());
}
BENCHMARK(sensors)
    ->ArgNames({"threads", "moving", "late_ms"})
    ->ArgsProduct({{1, 2}, {0, 1}, {0, 40}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
