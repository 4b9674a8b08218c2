// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Image.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace robotlink;

TEST(Image, colorsSurviveTheWayToYCbCrAndBack) {
  for (int r = 0; r < 256; r += 15) {
    for (int g = 0; g < 256; g += 15) {
      for (int b = 0; b < 256; b += 15) {
        const Rgb color{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                        static_cast<std::uint8_t>(b)};
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

TEST(Image, theSamePixelsInAllFormatsOfYCbCr) {
  // 2 x 2 pixels that share one chroma.
  const std::vector<std::pair<PixelFormat, std::vector<std::uint8_t>>> images = {
      {PixelFormat::kYuyv, {10, 90, 20, 180, 30, 90, 40, 180}},
      {PixelFormat::kUyvy, {90, 10, 180, 20, 90, 30, 180, 40}},
      {PixelFormat::kNv12, {10, 20, 30, 40, 90, 180}}};
  Image first;
  for (const auto& [format, data] : images) {
    Image image(2, 2, format);
    ASSERT_EQ(image.data.size(), data.size()) << encodingName(format);
    image.data = data;
    EXPECT_EQ(pixelYCbCr(image.view(), 0, 0), (YCbCr{10, 90, 180})) << encodingName(format);
    EXPECT_EQ(pixelYCbCr(image.view(), 1, 1), (YCbCr{40, 90, 180})) << encodingName(format);
    EXPECT_EQ(pixelRgb(image.view(), 1, 0), toRgb({20, 90, 180}));
    const Image rgb = toRgbImage(image.view());
    if (first.data.empty()) first = rgb;
    EXPECT_EQ(rgb, first) << encodingName(format);
  }
}

TEST(Image, bgrIsRgbTheOtherWayRound) {
  Image rgb(1, 1, PixelFormat::kRgb8), bgr(1, 1, PixelFormat::kBgr8);
  rgb.data = {200, 100, 50};
  bgr.data = {50, 100, 200};
  EXPECT_EQ(pixelRgb(bgr.view(), 0, 0), (Rgb{200, 100, 50}));
  EXPECT_EQ(pixelYCbCr(bgr.view(), 0, 0), pixelYCbCr(rgb.view(), 0, 0));
  EXPECT_EQ(toRgbImage(bgr.view()), rgb);
}

TEST(Image, whereChromaIsSharedSidesAreEven) {
  EXPECT_TRUE(canHaveSize(PixelFormat::kNv12, 4, 2));
  EXPECT_FALSE(canHaveSize(PixelFormat::kNv12, 4, 3));
  EXPECT_FALSE(canHaveSize(PixelFormat::kUyvy, 3, 2));
  EXPECT_TRUE(canHaveSize(PixelFormat::kYuyv, 2, 3));
  EXPECT_TRUE(canHaveSize(PixelFormat::kBgr8, 3, 3));
  EXPECT_FALSE(canHaveSize(PixelFormat::kRgb8, 0, 3));
}
