// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/LensShading.h"

#include <gmock/gmock.h>

#include <array>

namespace simcore::rendering {
namespace {

using robotlink::PixelFormat;
using testing::ElementsAre;
using testing::FloatEq;

constexpr int kShadedWidth = 3, kShadedHeight = 5, kShadedStride = 4;

CameraModel cameraWith(double falloff, double tint) {
  CameraModel camera;
  camera.width = kShadedWidth;
  camera.height = kShadedHeight;
  camera.vignetting = {falloff, tint};
  return camera;
}

/// The squared distance of a pixel from the center, 1 in the image's corners.
float squaredDistance(int x, int y) {
  const float dx = static_cast<float>(x) - 1, dy = static_cast<float>(y) - 2;
  return (dx * dx + dy * dy) / ((9 + 25) / 4.0F);
}

/// A strip of rows in which each pixel has a light of 1 and a color.
class LensShadingTest : public testing::Test {
 protected:
  void shade(const LensShading& shading, int firstRow, int rows, const std::array<float, 3>& color) {
    light_.fill(1);
    Strip strip;
    strip.firstRow = firstRow;
    strip.rows = rows;
    strip.light = light_.data();
    for (std::size_t k = 0; k < 3; ++k) {
      color_[k].fill(color[k]);
      strip.color[k] = color_[k].data();
    }
    shading.apply(strip, kShadedStride);
  }
  std::array<float, 3> colorAt(std::size_t pixel) const {
    return {color_[0][pixel], color_[1][pixel], color_[2][pixel]};
  }

  std::array<float, std::size_t{kShadedStride} * kShadedHeight> light_{};
  std::array<std::array<float, std::size_t{kShadedStride} * kShadedHeight>, 3> color_{};
};

TEST_F(LensShadingTest, aPerfectLensHasNoEffect) {
  EXPECT_FALSE(LensShading(cameraWith(0, 0), PixelFormat::kRgb8).any());
  EXPECT_TRUE(LensShading(cameraWith(0.1, 0), PixelFormat::kRgb8).any());
  EXPECT_TRUE(LensShading(cameraWith(0, 0.1), PixelFormat::kRgb8).any());
}

TEST_F(LensShadingTest, lightFallsOffWithTheSquareOfTheDistanceFromTheCenter) {
  const LensShading shading(cameraWith(0.5, 0), PixelFormat::kRgb8);
  shade(shading, 0, kShadedHeight, {10, 20, 30});
  for (int y = 0; y < kShadedHeight; ++y) {
    for (int x = 0; x < kShadedWidth; ++x) {
      const auto pixel = static_cast<std::size_t>(y * kShadedStride + x);
      EXPECT_FLOAT_EQ(light_[pixel], 1 - 0.5F * squaredDistance(x, y)) << x << ", " << y;
      EXPECT_THAT(colorAt(pixel), ElementsAre(FloatEq(10), FloatEq(20), FloatEq(30)));
    }
  }
  EXPECT_EQ(light_[2 * kShadedStride + 1], 1) << "nothing is lost in the center";
  EXPECT_EQ(light_[kShadedWidth], 1) << "what is behind a row is left alone";
}

TEST_F(LensShadingTest, aStripIsShadedAsThePartOfTheImageThatItIs) {
  const LensShading shading(cameraWith(1, 0), PixelFormat::kRgb8);
  shade(shading, 3, 1, {10, 20, 30});
  EXPECT_FLOAT_EQ(light_[0], 1 - squaredDistance(0, 3));
  EXPECT_FLOAT_EQ(light_[1], 1 - squaredDistance(1, 3));
  EXPECT_EQ(light_[kShadedStride], 1) << "only its rows are shaded";
}

TEST_F(LensShadingTest, aTintTakesRedAndGreenButNotBlue) {
  const LensShading shading(cameraWith(0, 0.5), PixelFormat::kRgb8);
  shade(shading, 0, kShadedHeight, {100, 80, 60});
  const float left = 1 - 0.5F * squaredDistance(0, 0);
  EXPECT_THAT(colorAt(0), ElementsAre(FloatEq(100 * left), FloatEq(80 * left), FloatEq(60)));
  EXPECT_EQ(light_[0], 1);
}

TEST_F(LensShadingTest, aTintIsTheSameInAnImageOfLuma) {
  const LensShading shading(cameraWith(0, 0.5), PixelFormat::kYuyv);
  const float red = 100, green = 80, blue = 60;
  shade(shading, 0, kShadedHeight,
        {0.299F * red + 0.587F * green + 0.114F * blue, -0.168736F * red - 0.331264F * green + 0.5F * blue,
         0.5F * red - 0.418688F * green - 0.081312F * blue});
  const float left = 1 - 0.5F * squaredDistance(0, 0);
  const auto [y, cb, cr] = colorAt(0);
  EXPECT_NEAR(y + 1.402F * cr, red * left, 0.01);
  EXPECT_NEAR(y - 0.344136F * cb - 0.714136F * cr, green * left, 0.01);
  EXPECT_NEAR(y + 1.772F * cb, blue, 0.01);
}

}  // namespace
}  // namespace simcore::rendering
