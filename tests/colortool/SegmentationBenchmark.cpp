// SPDX-License-Identifier: GPL-3.0-or-later
// How long an image takes through a colour table, and to its regions; beside a copy of the image's bytes in
// the same run.
#include <benchmark/benchmark.h>

#include <cstring>

#include "colortool/ColorTable.h"
#include "colortool/Regions.h"

namespace {

using colortool::ColorTable;
using robotlink::Image;
using robotlink::PixelFormat;

/// A field with a ball and lines: long runs with some noise, as cameras have it.
Image scene(int width, int height, PixelFormat format) {
  Image image(width, height, format);
  std::uint32_t noise = 1;
  for (auto& byte : image.data) {
    noise = noise * 1664525U + 1013904223U;
    byte = static_cast<std::uint8_t>(100 + (noise >> 30U));
  }
  if (format != PixelFormat::kYuyv) return image;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x + 1 < width; x += 2) {
      std::uint8_t* pair = image.row(y) + std::ptrdiff_t{2} * x;
      const int dx = x - width / 3, dy = y - height / 2;
      const bool ball = dx * dx + dy * dy < height * height / 64, line = (x + 2 * y) % 300 < 20;
      if (ball) pair[1] = 80, pair[3] = 190;
      if (line && !ball) pair[0] = pair[2] = 220, pair[1] = pair[3] = 128;
    }
  }
  return image;
}

ColorTable sceneTable() {
  ColorTable table;
  for (int y = 0; y < 64; ++y) {
    for (int cb = 0; cb < 64; ++cb) {
      for (int cr = 0; cr < 64; ++cr)
        table.setCell(y, cb, cr, cr > 40 ? 1 : y > 50 ? 2 : cb < 30 && cr < 30 ? 3 : 0);
    }
  }
  return table;
}

void count(benchmark::State& state, const Image& image) {
  const double pixels = static_cast<double>(image.width) * image.height;
  state.counters["ns_per_pixel"] = benchmark::Counter(
      pixels * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

Image imageOf(const benchmark::State& state, PixelFormat format) {
  return scene(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), format);
}

void copyOfTheImage(benchmark::State& state) {
  const Image image = imageOf(state, PixelFormat::kYuyv);
  std::vector<std::uint8_t> copy(image.data.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), image.data.data(), copy.size());
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
  count(state, image);
}

void classify(benchmark::State& state, PixelFormat format, ColorTable::Instructions instructions) {
  const Image image = imageOf(state, format);
  const ColorTable table = sceneTable();
  Image classes;
  for (auto _ : state) {
    table.classify(image.view(), classes, instructions);
    benchmark::DoNotOptimize(classes.data.data());
  }
  count(state, image);
}

void classifyAndFindRegions(benchmark::State& state) {
  const Image image = imageOf(state, PixelFormat::kYuyv);
  const ColorTable table = sceneTable();
  Image classes;
  colortool::RegionFinder finder{{}};
  for (auto _ : state) {
    table.classify(image.view(), classes);
    benchmark::DoNotOptimize(finder.findInRows(classes.view()).data());
  }
  count(state, image);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({176, 144})->Args({640, 480})->Args({1280, 960})->Unit(benchmark::kMicrosecond);
}
using Instructions = ColorTable::Instructions;

BENCHMARK(copyOfTheImage)->Apply(sizes);
BENCHMARK_CAPTURE(classify, yuyv, PixelFormat::kYuyv, Instructions::kFastest)->Apply(sizes);
BENCHMARK_CAPTURE(classify, yuyv_plain, PixelFormat::kYuyv, Instructions::kPlain)->Apply(sizes);
BENCHMARK_CAPTURE(classify, uyvy, PixelFormat::kUyvy, Instructions::kFastest)->Apply(sizes);
BENCHMARK_CAPTURE(classify, nv12, PixelFormat::kNv12, Instructions::kFastest)->Apply(sizes);
BENCHMARK_CAPTURE(classify, rgb8, PixelFormat::kRgb8, Instructions::kFastest)->Apply(sizes);
BENCHMARK_CAPTURE(classify, rgb8_plain, PixelFormat::kRgb8, Instructions::kPlain)->Apply(sizes);
BENCHMARK(classifyAndFindRegions)->Apply(sizes);

}  // namespace
