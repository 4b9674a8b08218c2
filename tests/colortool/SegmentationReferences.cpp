// SPDX-License-Identifier: GPL-3.0-or-later
// OpenCV's ways to what SegmentationBenchmark.cpp measures, on one thread.
#include <opencv2/imgproc.hpp>

#include "tests/colortool/SegmentationScene.h"

namespace {

using colortool::ColorTable;
using robotlink::Image;
using robotlink::PixelFormat;

constexpr int kTableSide = 512;  // 64 x 64 x 64 cells as a square
static_assert(std::size_t{kTableSide} * kTableSide == ColorTable::kCellCount);

cv::Mat square(const ColorTable& table) {
  cv::Mat image(kTableSide, kTableSide, CV_8UC1);
  std::ranges::copy(table.cells(), image.ptr());
  return image;
}

/// Where each pixel's cell is in the square.
void mapCells(const Image& image, cv::Mat& map) {
  map.create(image.height, image.width, CV_16SC2);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* from = image.row(y);
    auto* to = map.ptr<cv::Vec2s>(y);
    for (int x = 0; x < image.width; x += 2, from += 4, to += 2) {
      for (int i = 0; i < 2; ++i) {
        const auto cell = static_cast<int>(ColorTable::cellOf({from[2 * i], from[1], from[3]}));
        to[i] = {static_cast<short>(cell % kTableSide), static_cast<short>(cell / kTableSide)};
      }
    }
  }
}

void openCvRemap(benchmark::State& state, bool mapGiven) {
  cv::setNumThreads(1);
  const Image image = segmentationImage(state, PixelFormat::kYuyv);
  const ColorTable table = segmentationTable();
  const cv::Mat cells = square(table);
  cv::Mat map, classes;
  mapCells(image, map);
  for (auto _ : state) {
    if (!mapGiven) mapCells(image, map);
    cv::remap(cells, classes, map, cv::noArray(), cv::INTER_NEAREST);
    benchmark::DoNotOptimize(classes.data);
    benchmark::ClobberMemory();
  }
  Image ours;
  table.classify(image.view(), ours);
  if (!std::equal(ours.data.begin(), ours.data.end(), classes.ptr()))
    state.SkipWithError("other classes than ours");
  countPixels(state);
}

void openCvHsvRanges(benchmark::State& state) {
  cv::setNumThreads(1);
  Image image = segmentationImage(state, PixelFormat::kRgb8);
  const cv::Mat rgb(image.height, image.width, CV_8UC3, image.data.data());
  cv::Mat hsv, mask;
  for (auto _ : state) {
    cv::cvtColor(rgb, hsv, cv::COLOR_RGB2HSV);
    for (int colorClass = 0; colorClass < 8; ++colorClass) {
      cv::inRange(hsv, cv::Scalar(22 * colorClass, 80, 60), cv::Scalar(22 * colorClass + 21, 255, 255), mask);
      benchmark::DoNotOptimize(mask.data);
    }
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

/// Counts the field's class alone.
void openCvComponents(benchmark::State& state) {
  cv::setNumThreads(1);
  const Image image = segmentationImage(state, PixelFormat::kYuyv);
  Image classes;
  segmentationTable().classify(image.view(), classes);
  const cv::Mat field = cv::Mat(classes.height, classes.width, CV_8UC1, classes.data.data()) == 5;
  cv::Mat labels, statistics, centers;
  for (auto _ : state) {
    benchmark::DoNotOptimize(cv::connectedComponentsWithStats(field, labels, statistics, centers));
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

BENCHMARK_CAPTURE(openCvRemap, map_given, true)->Apply(imageSizes);
BENCHMARK_CAPTURE(openCvRemap, with_map, false)->Apply(imageSizes);
BENCHMARK(openCvHsvRanges)->Apply(imageSizes);
BENCHMARK(openCvComponents)->Apply(imageSizes);

}  // namespace
