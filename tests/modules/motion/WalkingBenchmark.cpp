// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how fast the robot really walks in the simulated physics, and what a frame of motion costs.
#include <benchmark/benchmark.h>

#include <cstdio>

#include "robotlink/base/Resources.h"
#include "tests/modules/motion/WalkingRobot.h"

namespace modules {
namespace {

constexpr WalkSpeed kSpeeds[] = {
    {0.05, 0, 0},   {0.1, 0, 0},    {0.15, 0, 0},      {-0.05, 0, 0}, {-0.1, 0, 0},   {-0.15, 0, 0},
    {0, 0.05, 0},   {0, 0.1, 0},    {0, 0.15, 0},      {0, -0.1, 0},  {0, -0.15, 0},  {0, 0, 0.3},
    {0, 0, 0.6},    {0, 0, 1},      {0, 0, -0.3},      {0, 0, -1},    {0.1, 0.05, 0}, {0.1, 0, 0.5},
    {0.1, 0, -0.5}, {0, 0.08, 0.4}, {0.06, -0.05, 0.4}};

WalkingRobot::Options options(FootMode mode) {
  WalkingRobot::Options options;
  options.resources = robotlink::resourceDirectory();
  options.gait = shippedGait(options.resources, mode);
  return options;
}

/// One row of the table for each speed; the counters say the same.
void walking(benchmark::State& state, FootMode mode) {
  const WalkSpeed wanted = kSpeeds[state.range(0)];
  WalkingRobot::Measured measured;
  for (auto _ : state) {
    WalkingRobot robot(options(mode));
    robot.placeBall({-1, 1});
    measured = robot.walk(wanted, 8);
  }
  char row[120];
  std::snprintf(row, sizeof row, "asked %+.3f %+.3f %+.2f  walked %+.3f %+.3f %+.2f", wanted.x, wanted.y,
                wanted.rotation, measured.speed.x, measured.speed.y, measured.speed.rotation);
  state.SetLabel(row);
}

void aFrameOfMotion(benchmark::State& state) {
  WalkingRobot robot(options(FootMode::kRectangle));
  robot.run({MotionCommand::Kind::kWalk, {0.1, 0, 0.2}, {}}, 2);
  MotionEngine engine = robot.engine();
  const robotlink::Vector3 acceleration(0, 0, 9.81);
  for (auto _ : state) {
    engine.advance(
        {{MotionCommand::Kind::kWalk, {0.1, 0, 0.2}, {}}, {}, &acceleration, std::chrono::milliseconds(8)});
    benchmark::DoNotOptimize(engine.positions().data());
  }
}

BENCHMARK_CAPTURE(walking, rectangle, FootMode::kRectangle)
    ->DenseRange(0, std::size(kSpeeds) - 1)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walking, halfEllipse, FootMode::kHalfEllipse)
    ->DenseRange(0, std::size(kSpeeds) - 1)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(aFrameOfMotion);

}  // namespace
}  // namespace modules
