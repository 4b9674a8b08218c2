// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <filesystem>

#include "colortool/table/ColorTable.h"
#include "colortool/table/ColorTableFile.h"
#include "robotlink/base/AtomicFile.h"

// The data of segmentation benchmarks: an image of a real camera and its team's table if they are available,
// otherwise similar generated ones. Images of any size are made by repeating pixels; all candidates are
// compared on the same data.

inline const std::filesystem::path kSegmentationData =
    ROBOTCONTROL_SOURCE_DIR "/../shared/data/colour/bhuman2009";

/// The colors of 320 x 240 pixels.
inline std::vector<robotlink::YCbCr> segmentationColors(int width, int height) {
  std::vector<robotlink::YCbCr> colors;
  if (const auto bytes = robotlink::readFile(kSegmentationData / "yuyv/066.yuyv")) {
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>((*bytes)[at]); };
    for (std::size_t at = 0; at + 3 < bytes->size(); at += 4)
      colors.push_back({byte(at + 2), byte(at + 1), byte(at + 3)});
  }
  if (colors.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) return colors;
  colors.clear();
  // A field with a ball and lines: long runs with some noise, as in camera images.
  std::uint32_t noise = 1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      noise = noise * 1664525U + 1013904223U;
      const int dx = x - width / 3, dy = y - height / 2, grain = static_cast<int>(noise >> 29U);
      const bool ball = dx * dx + dy * dy < height * height / 64, line = (x + 2 * y) % 150 < 10;
      const std::array<int, 3> color = ball   ? std::array{130, 80, 190}
                                       : line ? std::array{220, 128, 128}
                                              : std::array{90, 110, 100};
      colors.push_back({static_cast<std::uint8_t>(color[0] + grain),
                        static_cast<std::uint8_t>(color[1] + grain / 2),
                        static_cast<std::uint8_t>(color[2] + grain / 2)});
    }
  }
  return colors;
}

/// An image in a format; its size is taken from the arguments of the benchmark.
inline robotlink::Image segmentationImage(const benchmark::State& state, robotlink::PixelFormat format) {
  using robotlink::PixelFormat;
  constexpr int kWidth = 320, kHeight = 240;
  const auto colors = segmentationColors(kWidth, kHeight);
  const int width = static_cast<int>(state.range(0)), height = static_cast<int>(state.range(1));
  robotlink::Image image(width, height, format);
  for (int y = 0; y < height; ++y) {
    std::uint8_t* row = image.row(y);
    for (int x = 0; x < width; ++x) {
      const auto from = static_cast<std::size_t>(y * kHeight / height * kWidth + x * kWidth / width);
      const robotlink::YCbCr color = colors[from];
      const robotlink::Rgb rgb = robotlink::toRgb(color);
      if (format == PixelFormat::kYuyv || format == PixelFormat::kUyvy) {
        const int luma = format == PixelFormat::kYuyv ? 0 : 1;
        row[2 * x + luma] = color.y;
        row[2 * x + 1 - luma] = x % 2 == 0 ? color.cb : color.cr;
      } else if (format == PixelFormat::kRgb8) {
        row[3 * x] = rgb.r, row[3 * x + 1] = rgb.g, row[3 * x + 2] = rgb.b;
      } else {
        row[x] = color.y;
      }
    }
  }
  if (format == PixelFormat::kNv12) {
    const std::size_t lumas = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (std::size_t i = lumas; i < image.data.size(); ++i) {
      const std::size_t at = i - lumas, x = at % static_cast<std::size_t>(width),
                        y = 2 * (at / static_cast<std::size_t>(width));
      const robotlink::YCbCr color = colors[y * kHeight / static_cast<std::size_t>(height) * kWidth +
                                            x * kWidth / static_cast<std::size_t>(width)];
      image.data[i] = x % 2 == 0 ? color.cb : color.cr;
    }
  }
  return image;
}

inline colortool::ColorTable segmentationTable() {
  std::vector<std::uint8_t> same(256);
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<std::uint8_t>(i);
  if (const auto file = colortool::ColorTableFile::load(kSegmentationData / "tables/default.c64"))
    return colortool::ColorTable::translated(file->singleClasses(), same);
  colortool::ColorTable table;
  for (int y = 0; y < 64; ++y) {
    for (int cb = 0; cb < 64; ++cb) {
      for (int cr = 0; cr < 64; ++cr)
        table.setCell(y, cb, cr, cr > 40 ? 1 : y > 50 ? 4 : cb < 30 && cr < 30 ? 5 : 0);
    }
  }
  return table;
}

inline void countPixels(benchmark::State& state) {
  const double pixels = static_cast<double>(state.range(0)) * static_cast<double>(state.range(1));
  state.counters["ns_per_pixel"] = benchmark::Counter(
      pixels * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

inline void imageSizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({176, 144})->Args({640, 480})->Args({1280, 960})->Unit(benchmark::kMicrosecond);
}
