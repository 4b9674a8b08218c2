// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <cmath>
#include <sstream>

#include "robotlink/base/Random.h"
#include "tests/simcore/DriveScenes.h"

// What a step costs with Pioneers that drive about, by forces and by odometry, on open ground and between
// walls of a thousand pieces and more, as maps of buildings give them. A step is 4 ms, so 40 us are a percent
// of a core. "share" is the share of a core in real time.
namespace {

using namespace simcore;

constexpr double kRoom = 3;  // m, of a robot's own square

/// Walls around each robot's room, in pieces of 10 cm, with a door in each wall.
std::string rooms(int side) {
  std::ostringstream text;
  text << "<model name=\"walls\"><static>true</static><link name=\"walls\">";
  int pieces = 0;
  const auto piece = [&](double x, double y) {
    text << "<collision name=\"p" << pieces++ << "\"><pose>" << x << ' ' << y
         << " 0.5 0 0 0</pose><geometry><box><size>0.1 0.1 1</size></box></geometry></collision>";
  };
  for (int line = 0; line <= side; ++line) {
    for (double along = 0; along < side * kRoom; along += 0.1) {
      if (std::abs(std::remainder(along - kRoom / 2, kRoom)) < 0.5) continue;
      piece((line - 0.5) * kRoom, along - kRoom / 2);
      piece(along - kRoom / 2, (line - 0.5) * kRoom);
    }
  }
  text << "</link></model>";
  return text.str();
}

std::string pioneers(int count, int side) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double x = kRoom * (i % side), y = kRoom * (i / side);
    text += pioneerAt("p3at" + std::to_string(i + 1), x, y, 0.3 * i);
  }
  return text;
}

/// Each goes in curves of its own, and backs away from what blocks it.
void wander(DrivenWorld& world) {
  for (std::size_t i = 0; i < world->drives().size(); ++i) {
    const WheelState& state = world->wheelState(i);
    robotlink::Random random(i, world->steps() / 500);
    const double speed = random.uniform(0.1, 0.6), curve = random.uniform(-0.2, 0.2);
    if (state.leftBlocked || state.rightBlocked) {
      world->requestWheelSpeeds(i, -state.leftSpeed - 0.3, -state.rightSpeed - 0.2);
    } else if (world->steps() % 500 == 0) {
      world->requestWheelSpeeds(i, speed - curve, speed + curve);
    }
  }
}

void drivePioneers(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  const bool kinematic = state.range(1) != 0, walls = state.range(2) != 0;
  const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(count))));
  const std::string contents = (walls ? rooms(std::max(side, 6)) : "") + pioneers(count, side);
  DrivenWorld world(contents, {.seed = 1, .noise = true, .kinematic = kinematic});
  std::uint64_t touches = 0;
  for ([[maybe_unused]] const auto _ : state) {
    if (world->steps() % 25 == 0) {
      state.PauseTiming();
      wander(world);
      state.ResumeTiming();
    }
    world->step();
  }
  for (int i = 0; i < count; ++i) touches += world->obstacleContacts("p3at" + std::to_string(i + 1));
  state.counters["share"] = benchmark::Counter(0.004 * static_cast<double>(state.iterations()),
                                               benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["touches"] = static_cast<double>(touches);
}
BENCHMARK(drivePioneers)
    ->ArgNames({"robots", "kinematic", "walls"})
    ->ArgsProduct({{1, 10, 100}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
