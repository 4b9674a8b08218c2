// SPDX-License-Identifier: GPL-3.0-or-later
// How long an image takes through a color table, and to its regions; beside a copy of the image's bytes, and
// OpenCV's ways to the same (SegmentationReferences.cpp), in the same run.
#include <cstring>

#include "colortool/image/Regions.h"
#include "tests/colortool/SegmentationScene.h"

namespace {

using colortool::ColorTable;
using robotlink::Image;
using robotlink::PixelFormat;

void copyOfTheImage(benchmark::State& state) {
  const Image image = segmentationImage(state, PixelFormat::kYuyv);
  std::vector<std::uint8_t> copy(image.data.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), image.data.data(), copy.size());
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

void classify(benchmark::State& state, PixelFormat format, ColorTable::Instructions instructions) {
  const Image image = segmentationImage(state, format);
  const ColorTable table = segmentationTable();
  Image classes;
  for (auto _ : state) {
    table.classify(image.view(), classes, instructions);
    benchmark::DoNotOptimize(classes.data.data());
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

void classifyAndFindRegions(benchmark::State& state) {
  const Image image = segmentationImage(state, PixelFormat::kYuyv);
  const ColorTable table = segmentationTable();
  Image classes;
  colortool::RegionFinder finder{{}};
  for (auto _ : state) {
    table.classify(image.view(), classes);
    benchmark::DoNotOptimize(finder.findInRows(classes.view()).data());
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

using Instructions = ColorTable::Instructions;

BENCHMARK(copyOfTheImage)->Apply(imageSizes);
BENCHMARK_CAPTURE(classify, yuyv, PixelFormat::kYuyv, Instructions::kFastest)->Apply(imageSizes);
BENCHMARK_CAPTURE(classify, yuyv_plain, PixelFormat::kYuyv, Instructions::kPlain)->Apply(imageSizes);
BENCHMARK_CAPTURE(classify, uyvy, PixelFormat::kUyvy, Instructions::kFastest)->Apply(imageSizes);
BENCHMARK_CAPTURE(classify, nv12, PixelFormat::kNv12, Instructions::kFastest)->Apply(imageSizes);
BENCHMARK_CAPTURE(classify, rgb8, PixelFormat::kRgb8, Instructions::kFastest)->Apply(imageSizes);
BENCHMARK_CAPTURE(classify, rgb8_plain, PixelFormat::kRgb8, Instructions::kPlain)->Apply(imageSizes);
BENCHMARK(classifyAndFindRegions)->Apply(imageSizes);

}  // namespace
