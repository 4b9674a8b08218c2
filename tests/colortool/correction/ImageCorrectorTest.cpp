// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/correction/ImageCorrector.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace colortool {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;
using robotlink::YCbCr;

ColorCorrection strongCorrection() {
  ColorCorrection correction;
  correction.vignetting = {{-0.35, -0.15}, {6, 3}, {-8, 2}};
  correction.channels = {{{1.1, -7}, {0.95, 4}, {1.05, 0}}};
  return correction;
}

Image randomImage(int width, int height, PixelFormat format) {
  std::mt19937 random(static_cast<unsigned>(width));
  Image image(width, height, format);
  for (std::uint8_t& byte : image.data) byte = static_cast<std::uint8_t>(random());
  return image;
}

int difference(YCbCr a, YCbCr b) {
  return std::max({std::abs(a.y - b.y), std::abs(a.cb - b.cb), std::abs(a.cr - b.cr)});
}

class ImageCorrectorTest : public testing::TestWithParam<PixelFormat> {};

TEST_P(ImageCorrectorTest, eachPixelBecomesWhatTheCorrectionMakesOfIt) {
  ImageCorrector corrector(strongCorrection());
  Image corrected;
  for (const auto& [width, height] : {std::pair(160, 120), {50, 38}, {160, 120}}) {
    const Image image = randomImage(width, height, GetParam());
    corrector.correct(image.view(), corrected);
    ASSERT_EQ(corrected.width, width);
    ASSERT_EQ(corrected.height, height);
    ASSERT_EQ(corrected.format, GetParam());
    ASSERT_EQ(corrected.data.size(), image.data.size());
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        YCbCr expected = strongCorrection().apply(pixelYCbCr(image.view(), x, y), x, y, width, height);
        const YCbCr found = pixelYCbCr(corrected.view(), x, y);
        if (bytesPerPixel(GetParam()) == 3) {
          const robotlink::Rgb clipped = toRgb(expected), rgb = pixelRgb(corrected.view(), x, y);
          ASSERT_LE(std::max({std::abs(rgb.r - clipped.r), std::abs(rgb.g - clipped.g),
                              std::abs(rgb.b - clipped.b)}),
                    3)
              << x << ", " << y;
          continue;
        }
        if (GetParam() == PixelFormat::kMono8) expected = {expected.y, 128, 128};
        ASSERT_LE(difference(found, expected), 1) << x << ", " << y;
      }
    }
  }
}

TEST_P(ImageCorrectorTest, withoutACorrectionTheImageIsTheSame) {
  const Image image = randomImage(32, 24, GetParam());
  Image corrected;
  ImageCorrector({}).correct(image.view(), corrected);
  EXPECT_EQ(corrected, image);
}

std::string nameOf(const testing::TestParamInfo<PixelFormat>& info) {
  return std::string(encodingName(info.param));
}
INSTANTIATE_TEST_SUITE_P(Formats, ImageCorrectorTest, testing::ValuesIn(robotlink::kPixelFormats), nameOf);

TEST(ImageCorrector, rowsWithGapsAreReadRight) {
  const Image wide = randomImage(64, 24, PixelFormat::kYuyv);
  robotlink::ImageView part = wide.view();
  part.width = 32;
  Image corrected;
  ImageCorrector(strongCorrection()).correct(part, corrected);
  ASSERT_EQ(corrected.width, 32);
  for (int y = 0; y < 24; ++y) {
    EXPECT_LE(difference(yuyvPixel(corrected.view(), 31, y),
                         strongCorrection().apply(yuyvPixel(wide.view(), 31, y), 31, y, 32, 24)),
              2);
  }
}

TEST(ImageCorrector, theStrongestCorrectionIsDoneInIntegersToo) {
  ColorCorrection correction;
  correction.vignetting.luma = {-3, 0};  // past black
  correction.channels = {{{40, -2000}, {-40, 5000}, {0, 77}}};
  const Image image = randomImage(160, 120, PixelFormat::kUyvy);
  Image corrected;
  ImageCorrector(correction).correct(image.view(), corrected);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const YCbCr expected = correction.apply(pixelYCbCr(image.view(), x, y), x, y, 160, 120);
      ASSERT_LE(difference(pixelYCbCr(corrected.view(), x, y), expected), 1) << x << ", " << y;
    }
  }
}

TEST(ImageCorrector, anEmptyImageStaysEmpty) {
  Image corrected(8, 8, PixelFormat::kYuyv);
  ImageCorrector(strongCorrection()).correct({}, corrected);
  EXPECT_TRUE(corrected.view().empty());
  EXPECT_TRUE(corrected.data.empty());
}

}  // namespace
}  // namespace colortool
