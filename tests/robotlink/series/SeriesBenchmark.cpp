// SPDX-License-Identifier: GPL-3.0-or-later
// How long the pyramid above five million points takes, and how long asking it for the columns of a picture.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

#include "robotlink/series/Series.h"

namespace robotlink {
namespace {

constexpr std::size_t kPoints = 5'000'000, kColumns = 1600;

double valueOf(std::size_t i) {
  return std::sin(static_cast<double>(i) * 1e-4) + 1e-3 * static_cast<double>(i * 2'654'435'761U % 1000U);
}

const std::vector<Series::Point>& points() {
  static const std::vector<Series::Point> kAll = [] {
    std::vector<Series::Point> all;
    for (std::size_t i = 0; i < kPoints; ++i) all.push_back({static_cast<double>(i) * 1e-3, valueOf(i)});
    return all;
  }();
  return kAll;
}

/// The least that it takes to keep the points: the memory for them, filled.
void store(benchmark::State& state) {
  const auto& all = points();
  for (auto unused : state) {
    static_cast<void>(unused);
    std::vector<std::unique_ptr<double[]>> blocks;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const std::size_t place = i % Series::kBlock;
      if (place == 0) blocks.push_back(std::make_unique_for_overwrite<double[]>(2 * Series::kBlock));
      blocks.back()[place] = all[i].time;
      blocks.back()[Series::kBlock + place] = all[i].value;
    }
    benchmark::DoNotOptimize(blocks.data());
  }
}
BENCHMARK(store)->Unit(benchmark::kMillisecond);

/// The same with the pyramid: what it takes longer is the pyramid's.
void build(benchmark::State& state) {
  const auto& all = points();
  for (auto unused : state) {
    static_cast<void>(unused);
    Series series;
    for (const Series::Point& point : all) series.append(point);
    benchmark::DoNotOptimize(series.size());
    state.counters["bytesPerPoint"] = static_cast<double>(series.bytes()) / kPoints;
  }
}
BENCHMARK(build)->Unit(benchmark::kMillisecond);

/// The argument is the share of the points that is seen, in thousandths.
void ask(benchmark::State& state) {
  Series series;
  for (const Series::Point& point : points()) series.append(point);
  const double to = series.back().time * static_cast<double>(state.range(0)) / 1000;
  for (auto unused : state) {
    static_cast<void>(unused);
    benchmark::DoNotOptimize(series.columns(0, to, kColumns));
  }
}
BENCHMARK(ask)->Arg(1000)->Arg(10)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace robotlink
