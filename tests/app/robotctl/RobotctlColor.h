// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "logplayer/images/ImageCoding.h"
#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

inline void writeBytes(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// A folder with an image of three vertical bars (orange, green, a wall), its labels, and a stroke in each
/// bar, in which `robotctl color` is run.
class RobotctlColor : public testing::Test {
 protected:
  static constexpr int kWidth = 320, kHeight = 240;
  static constexpr std::array<robotlink::YCbCr, 3> kBars = {
      robotlink::YCbCr{150, 90, 190}, robotlink::YCbCr{90, 110, 100}, robotlink::YCbCr{180, 126, 130}};
  /// The class numbers of the bars.
  static constexpr std::array<std::uint8_t, 3> kLabels = {1, 5, 0};

  void SetUp() override {
    std::vector<std::uint8_t> pixels;
    robotlink::Image labels(kWidth, kHeight, robotlink::PixelFormat::kMono8);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const auto bar = static_cast<std::size_t>(x * 3 / kWidth);
        // The first brightness of each four bytes does not belong to the pixel.
        const auto brightness = static_cast<std::uint8_t>(kBars[bar].y + (x + y) % 9);
        pixels.insert(pixels.end(), {0, kBars[bar].cb, brightness, kBars[bar].cr});
        labels.row(y)[x] = x % 10 == 0 ? std::uint8_t{255} : kLabels[bar];
      }
    }
    for (const char* name : {"images", "labels"}) std::filesystem::create_directory(folder_ / name);
    writeBytes(folder_ / "images/000.yuyv", pixels);
    writeBytes(folder_ / "images/007.yuyv", pixels);
    writeBytes(folder_ / "labels/000.png", logplayer::encodePng(labels.view()).value());
    std::ofstream(folder_ / "strokes.csv")
        << "image,class,x,y,radius\n000.yuyv,orange,50,100,3\n000.yuyv,green,150,100,3\n"
           "000.yuyv,background,260,100,3\n";
  }
  RobotctlOutcome color(const std::string& arguments) const {
    return runRobotctl(folder_.path(), "color " + arguments);
  }
  RobotctlOutcome train() const { return color("train --strokes strokes.csv --images images --out t.c64"); }

  TestFolder folder_;
};
