// SPDX-License-Identifier: GPL-3.0-or-later
// From a stroke to the new table, and a table from scratch, with ten strokes a class of five and background
// beforehand; the same with clean-up.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>

#include "colortool/ColorVotes.h"
#include "colortool/TableCleanUp.h"

namespace {

using colortool::ColorTable;
using colortool::ColorVotes;
using robotlink::YCbCr;

constexpr int kClasses = 6, kStrokes = 10, kPixels = 29;

/// The pixels of a stroke: one colour of the class, with what light and noise make of it.
std::vector<std::size_t> stroke(int colorClass, std::mt19937& random) {
  std::normal_distribution<double> brightness(0, 12), chroma(0, 3);
  const double y = 70 + 30 * colorClass + brightness(random);
  std::vector<std::size_t> cells;
  for (int i = 0; i < kPixels; ++i) {
    const auto value = [&](double center, double off) {
      return static_cast<std::uint8_t>(std::clamp(center + off, 0.0, 255.0));
    };
    cells.push_back(
        ColorTable::cellOf({value(y, brightness(random) / 3), value(90 + 15 * colorClass, chroma(random)),
                            value(170 - 13 * colorClass, chroma(random))}));
  }
  return cells;
}

void add(ColorVotes& votes, const std::vector<std::size_t>& cells, int colorClass, int sign) {
  for (const std::size_t cell : cells)
    votes.add(cell, static_cast<std::uint8_t>(colorClass), sign * ColorVotes::kUnit);
}

ColorVotes calibrated(std::mt19937& random) {
  ColorVotes votes(kClasses);
  for (int i = 0; i < kStrokes * kClasses; ++i) add(votes, stroke(i % kClasses, random), i % kClasses, 1);
  votes.update();
  return votes;
}

/// One more stroke, or its undoing.
void strokeToTable(benchmark::State& state) {
  std::mt19937 random(1);
  ColorVotes votes = calibrated(random);
  const auto cells = stroke(2, random);
  int sign = -1;
  for (auto _ : state) {
    sign = -sign;
    add(votes, cells, 2, sign);
    benchmark::DoNotOptimize(&votes.update());
  }
}

void rebuild(benchmark::State& state) {
  std::mt19937 random(1);
  ColorVotes votes = calibrated(random);
  colortool::VoteOptions options;
  for (auto _ : state) {
    options.radius = options.radius == 8 ? 8.5 : 8;
    votes.setOptions(options);
    benchmark::DoNotOptimize(&votes.update());
  }
}

/// Clean-up alone, after each stroke.
void cleanUpAfterStroke(benchmark::State& state) {
  std::mt19937 random(1);
  ColorVotes votes = calibrated(random);
  colortool::TableCleanUp cleanUp;
  const auto cells = stroke(2, random);
  int sign = -1;
  for (auto _ : state) {
    state.PauseTiming();
    sign = -sign;
    add(votes, cells, 2, sign);
    const ColorTable& raw = votes.update();
    state.ResumeTiming();
    benchmark::DoNotOptimize(&cleanUp.clean(raw, votes.sampledCells(), {}));
  }
}

void cleanUpFromScratch(benchmark::State& state) {
  std::mt19937 random(1);
  ColorVotes votes = calibrated(random);
  const ColorTable& raw = votes.update();
  for (auto _ : state) {
    colortool::TableCleanUp cleanUp;
    benchmark::DoNotOptimize(&cleanUp.clean(raw, votes.sampledCells(), {}));
  }
}

BENCHMARK(strokeToTable)->Unit(benchmark::kMicrosecond);
BENCHMARK(rebuild)->Unit(benchmark::kMicrosecond);
BENCHMARK(cleanUpAfterStroke)->Unit(benchmark::kMicrosecond);
BENCHMARK(cleanUpFromScratch)->Unit(benchmark::kMicrosecond);

}  // namespace
