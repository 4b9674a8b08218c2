// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame's debug messages cost on their way into the session: a camera image and twenty packages that
// keys show, shared as they are inside a program, against what any link does, that is serialized and parsed.
// Both are measured in turn, in one run; "ratio" is the quotient of the medians.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "foxglove/Image.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/DebugContext.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"

using namespace robotlink;

namespace {

constexpr int kPackages = 20;
constexpr int kFrames = 50;

struct ShownPackage {
  std::string path;
  PackagePtr value;
};

/// What the processes of a robot send in a frame.
std::vector<ShownPackage> packagesOfAFrame() {
  auto image = std::make_shared<foxglove::RawImage>();
  assign(*image, Image(208, 160, PixelFormat::kYuyv).view(), Instant(), "red1");
  std::vector<ShownPackage> packages{{"camera/image", image}};
  for (int i = 0; i < kPackages; ++i) {
    auto players = std::make_shared<robotcontrol::PlayersModel>();
    for (int robot = 0; robot < 8; ++robot) {
      auto& player = *players->add_players();
      player.mutable_position_in_field()->set_x(robot);
      player.set_confidence(0.9);
    }
    packages.push_back({"models/players-" + std::to_string(i), players});
  }
  return packages;
}

/// Seconds for kFrames frames, from the processes' packages into the history. `carry` takes a queue over.
template <typename Carry>
double secondsFor(const std::vector<ShownPackage>& packages, const Carry& carry) {
  ManualClock clock;
  DebugContext debug("cognition", clock, {});
  Session session({.age = std::chrono::milliseconds(200)});
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kFrames; ++i) {
    clock.advance(std::chrono::milliseconds(40));
    debug.beginFrame(clock.now(), static_cast<std::uint64_t>(i));
    for (const ShownPackage& package : packages) debug.package(package.path, package.value);
    debug.endFrame();
    session.pushQueue("red1", carry(debug.takeQueue()));
    session.tick();
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void aFrameIntoTheSessionSharedAgainstSerialized(benchmark::State& state) {
  const auto packages = packagesOfAFrame();
  std::vector<double> shared, serialized;
  for ([[maybe_unused]] auto round : state) {
    shared.push_back(
        secondsFor(packages, [](std::shared_ptr<const SharedDebugQueue> queue) { return queue; }));
    serialized.push_back(secondsFor(packages, [](const std::shared_ptr<const SharedDebugQueue>& queue) {
      robotcontrol::DebugQueue received;
      received.ParseFromString(toWire(*queue).SerializeAsString());
      return fromWire(std::move(received));
    }));
  }
  state.counters["us_shared"] = 1e6 * median(shared) / kFrames;
  state.counters["us_serialized"] = 1e6 * median(serialized) / kFrames;
  state.counters["ratio"] = median(serialized) / median(shared);
}
BENCHMARK(aFrameIntoTheSessionSharedAgainstSerialized)->Iterations(40)->Unit(benchmark::kMillisecond);

}  // namespace
