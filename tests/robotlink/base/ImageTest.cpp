// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Image.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace robotlink;

TEST(Image, coloursSurviveTheWayToYCbCrAndBack) {
  for (int r = 0; r < 256; r += 15) {
    for (int g = 0; g < 256; g += 15) {
      for (int b = 0; b < 256; b += 15) {
        const Rgb color{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g), static_cast<std::uint8_t>(b)};
        const Rgb back = toRgb(toYCbCr(color));
        EXPECT_LE(std::abs(back.r - r), 2);
        EXPECT_LE(std::abs(back.g - g), 2);
        EXPECT_LE(std::abs(back.b - b), 2);
      }
    }
  }
}

TEST(Image, yuyvPixelsShareTheirChroma) {
  Image image(4, 1, PixelFormat::kYuyv);
  image.data = {10, 20, 30, 40, 50, 60, 70, 80};
  EXPECT_EQ(yuyvPixel(image.view(), 0, 0), (YCbCr{10, 20, 40}));
  EXPECT_EQ(yuyvPixel(image.view(), 3, 0), (YCbCr{70, 60, 80}));
}
