// SPDX-License-Identifier: GPL-3.0-or-later
// From a stroke to the new table, and a table from scratch, with ten strokes a class of five and background
// beforehand; clean-up and cross-validation of
// such tables, and the correction of images.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>

#include "colortool/correction/ImageCorrector.h"
#include "colortool/scoring/CrossValidation.h"
#include "colortool/votes/ColorVotes.h"
#include "colortool/votes/TableCleanUp.h"

namespace {

using colortool::ColorTable;
using colortool::ColorVotes;
using robotlink::YCbCr;

constexpr int kClasses = 6, kStrokes = 10, kPixels = 29;

/// The pixels of a stroke: one color of the class, with what light and noise make of it.
std::vector<YCbCr> strokeColors(int colorClass, std::mt19937& random) {
  std::normal_distribution<double> brightness(0, 12), chroma(0, 3);
  const double y = 70 + 30 * colorClass + brightness(random);
  std::vector<YCbCr> colors;
  for (int i = 0; i < kPixels; ++i) {
    const auto value = [&](double center, double off) {
      return static_cast<std::uint8_t>(std::clamp(center + off, 0.0, 255.0));
    };
    colors.push_back({value(y, brightness(random) / 3), value(90 + 15 * colorClass, chroma(random)),
                      value(170 - 13 * colorClass, chroma(random))});
  }
  return colors;
}

std::vector<std::size_t> stroke(int colorClass, std::mt19937& random) {
  std::vector<std::size_t> cells;
  for (const YCbCr color : strokeColors(colorClass, random)) cells.push_back(ColorTable::cellOf(color));
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

/// The votes of 100 strokes.
void crossValidation(benchmark::State& state) {
  std::mt19937 random(1);
  colortool::Samples samples;
  samples.classes = colortool::ColorClasses(std::vector<colortool::NamedColor>(kClasses - 1));
  samples.images.push_back({1, "image", "camera", "", 40, 1});
  for (int i = 0; i < 100; ++i) {
    colortool::Stroke made;
    made.id = static_cast<std::uint64_t>(i) + 1;
    made.image = 1;
    made.colorClass = static_cast<std::uint8_t>(i % kClasses);
    made.area = {{0, 0, kPixels}};
    made.colors = strokeColors(i % kClasses, random);
    samples.strokes.push_back(std::make_shared<colortool::Stroke>(std::move(made)));
  }
  double recall = 0;
  for (auto _ : state) recall = colortool::crossValidate(samples)->evaluation.meanRecall();
  state.counters["mean_recall"] = recall;
}

/// An image of 640 x 480 of that format.
void correctImage(benchmark::State& state) {
  colortool::ColorCorrection correction;
  correction.vignetting = {{-0.3, -0.1}, {4, 2}, {-5, 1}};
  correction.channels[0] = {1.1, -4};
  colortool::ImageCorrector corrector(correction);
  const robotlink::Image image(640, 480, static_cast<robotlink::PixelFormat>(state.range(0)));
  state.SetLabel(std::string(encodingName(image.format)));
  robotlink::Image corrected;
  for (auto _ : state) {
    corrector.correct(image.view(), corrected);
    benchmark::DoNotOptimize(corrected.data.data());
  }
}

BENCHMARK(strokeToTable)->Unit(benchmark::kMicrosecond);
BENCHMARK(rebuild)->Unit(benchmark::kMicrosecond);
BENCHMARK(cleanUpAfterStroke)->Unit(benchmark::kMicrosecond);
BENCHMARK(cleanUpFromScratch)->Unit(benchmark::kMicrosecond);
BENCHMARK(crossValidation)->Unit(benchmark::kMillisecond);
BENCHMARK(correctImage)->DenseRange(0, 4)->Unit(benchmark::kMicrosecond);

}  // namespace
