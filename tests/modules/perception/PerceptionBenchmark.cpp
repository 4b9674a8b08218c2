// SPDX-License-Identifier: GPL-3.0-or-later
// What one image costs in each step of perception, beside copying it.
#include <benchmark/benchmark.h>

#include <cstring>

#include "modules/perception/BandLandmarkFinder.h"
#include "modules/perception/CircleBallFinder.h"
#include "modules/perception/HorizonLandmarkFinder.h"
#include "modules/perception/RegionBallFinder.h"
#include "tests/modules/perception/FieldCamera.h"

namespace modules {
namespace {

/// The ball, a goal and two beacons.
struct View {
  FieldCamera world;
  CameraView view = FieldCamera::view({-0.1, 0, 0});
  robotlink::Image image;
  std::vector<colortool::Region> regions, orange;
  std::vector<FieldLandmark> landmarks = fieldLandmarks(world.field(), world.classes());

  View() {
    world.putBall({0.2, 0.1});
    image = world.look({-0.8, 0, 0}, view);
    regions = world.regions();
    orange = world.regions("orange");
  }
};

const View& seen() {
  static const View view;
  return view;
}

void copyImage(benchmark::State& state) {
  const View& v = seen();
  std::vector<std::uint8_t> copy(v.image.data.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), v.image.data.data(), copy.size());
    benchmark::DoNotOptimize(copy.data());
  }
}
BENCHMARK(copyImage);

void makeColorTable(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(fieldColorTable(seen().world.field(), seen().world.classes(), {}));
}
BENCHMARK(makeColorTable);

void segmentWholeImage(benchmark::State& state) {
  const View& v = seen();
  robotlink::Image classes;
  colortool::RegionFinder finder({});
  for (auto _ : state) {
    v.world.table().classify(v.image.view(), classes);
    benchmark::DoNotOptimize(finder.findInRows(classes.view()).data());
  }
}
BENCHMARK(segmentWholeImage);

void segmentByScanLines(benchmark::State& state) {
  const View& v = seen();
  robotlink::Image classes;
  colortool::RegionFinder finder({});
  for (auto _ : state) {
    v.world.table().classify(v.image.view(), classes);
    benchmark::DoNotOptimize(finder.findInColumns(classes.view(), 2).data());
  }
}
BENCHMARK(segmentByScanLines);

void findBallByRegion(benchmark::State& state) {
  const RegionBallFinder finder({});
  for (auto _ : state) benchmark::DoNotOptimize(finder.find(seen().orange, seen().view));
}
BENCHMARK(findBallByRegion);

void findBallByCircle(benchmark::State& state) {
  CircleBallFinder finder({});
  for (auto _ : state) benchmark::DoNotOptimize(finder.find(seen().image.view(), seen().orange, seen().view));
}
BENCHMARK(findBallByCircle);

void findLandmarksByBands(benchmark::State& state) {
  const BandLandmarkFinder finder(seen().world.field(), seen().landmarks, {});
  for (auto _ : state) benchmark::DoNotOptimize(finder.find(seen().regions, seen().view));
}
BENCHMARK(findLandmarksByBands);

void findLandmarksOnTheHorizon(benchmark::State& state) {
  HorizonLandmarkFinder finder(seen().world.field(), seen().landmarks, seen().world.table(), {});
  for (auto _ : state) benchmark::DoNotOptimize(finder.find(seen().image.view(), seen().view));
}
BENCHMARK(findLandmarksOnTheHorizon);

}  // namespace
}  // namespace modules
